//! Points from a table of separated cells.

mod advice;
mod counting;
mod decimals;
mod header;
mod properties;
mod rows;
mod separator;
mod start;
mod text;

use self::rows::{CalledCenters, cells, parsed};
use std::path::Path;

use csv::ByteRecord;

use self::advice::{available, joins_digits, may_be_atoms, may_be_halves, on_one_column};
pub(super) use self::counting::Counting;
use self::decimals::Decimals;
use self::header::{Opening, column_of_text, has_number, is_grid, is_text, opening, text_above_number};
use self::start::{RowInDoubt, Start, Use};
use self::text::{Naming, Text};
use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem};
use super::names::Order;
use super::number::{Losses, is_number};
use super::points::push_limited;
use super::points::{COORDINATE_LIMIT, Points, Wanted};
use super::reading::{Reading, Skipping, columns_of};
use super::{encoding, names};

/// The place of the points in a table.
pub(super) struct Shape<'a> {
    /// The columns that hold the coordinates; guessed if absent.
    pub(super) columns: Option<&'a Columns>,
    /// The number of lines that are left out at the start; a header is told from its cells if absent.
    pub(super) skip: Option<u64>,
    /// The number of coordinates that there should be.
    pub(super) wanted: Wanted,
    /// Whether the caller has the options that say how the first row is read.
    pub(super) has_options: bool,
    /// Whether the first three columns are coordinates where names do not say otherwise.
    pub(super) is_cloud: bool,
}

impl Shape<'_> {
    fn use_of(&self) -> Use {
        match self.skip {
            Some(_) => Use::Told,
            None if self.is_cloud => Use::Cloud,
            None => Use::Table,
        }
    }

    /// A remark, with an advice where the caller has its option.
    fn advised(&self, remark: String, advice: &str) -> String {
        if self.has_options { format!("{remark}; {advice}") } else { remark }
    }
}

/// Reads the points of a table.
///
/// The first row is a header if the chosen columns are named, or if it cannot be data: it has no number, and some
/// chosen cell is text that does not look like a broken number; or if it numbers the columns, while all other rows are
/// fractions. Where a row with numbers has text above a number, it is refused: in a chosen column the text is no
/// number, elsewhere the caller says by `skip`, the number of lines to leave out at the start, whether it is a header.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    shape: &Shape,
    skipping: &mut Skipping,
) -> Result<Reading, InputError> {
    let asked: Vec<&str> = shape.columns.map(Columns::names).into_iter().flatten().collect();
    let text = Text::new(decoded(file, content)?, shape.skip.unwrap_or(0), Naming::Points(&asked));
    let mut reading = Table::new(file, &text).points(shape, skipping)?;
    reading.left_out.extend(text.left_out());
    Ok(reading)
}

/// The numbers of a table, row by row.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// The names of the columns, if there is a header.
    pub(super) names: Vec<String>,
    /// The rows, of the same length.
    pub(super) numbers: Vec<Vec<f64>>,
    /// The line of the header, if there is one with names.
    pub(super) header: Option<u64>,
    /// The first rows that a column of names calls a centre, by their places, with their lines.
    pub(super) centers: Vec<(usize, u64)>,
    /// The first line of comment that says something of a centre, with its text.
    pub(super) comment_on_center: Option<(u64, String)>,
    /// Remarks on the reading: rows and columns that were left out, decimal commas.
    pub(super) notes: Vec<String>,
}

impl Rows {
    /// Whether the header names coordinates, so that the rows may be meant as points.
    pub(super) fn are_named_as_points(&self) -> bool {
        names::are_coordinates(&self.names)
    }
}

/// Reads all the numbers of a table, row by row: rows of the same length, after a header line that is recognised as
/// above, without a column that counts the rows.
///
/// Columns that are named as coordinates are put in their order, and labels of rows are left out, as `order` says.
pub(super) fn rows(file: &Path, content: &[u8], order: Order, skip: Option<u64>) -> Result<Rows, InputError> {
    let text = Text::new(decoded(file, content)?, skip.unwrap_or(0), Naming::Vectors);
    Table::new(file, &text).numbers(order, if skip.is_some() { Use::Told } else { Use::Vectors })
}

fn decoded<'a>(file: &Path, content: &'a [u8]) -> Result<std::borrow::Cow<'a, [u8]>, InputError> {
    let text = encoding::text(content).map_err(|problem| problem.at(file, Place::File))?;
    if is_grid(&text) {
        let grid = "is a grid of heights, which holds no points".to_owned();
        return Err(Problem::Shape(grid).at(file, Place::File));
    }
    Ok(text)
}

struct Table<'a> {
    file: &'a Path,
    text: &'a Text<'a>,
    decimals: Decimals,
    losses: Losses,
    /// The cells of a row, an empty one after a trailing separator apart.
    width: usize,
}

impl<'a> Table<'a> {
    fn new(file: &'a Path, text: &'a Text<'a>) -> Self {
        Self { file, text, decimals: Decimals::default(), losses: Losses::default(), width: 0 }
    }

    fn numbers(mut self, order: Order, use_of: Use) -> Result<Rows, InputError> {
        let text = self.text;
        let mut records = text.rows();
        let Some(mut start) = Start::read(self.file, text, &mut records, use_of)? else {
            return Ok(Rows::default());
        };
        self.width = start.width;
        if !start.is_numbered {
            let all: Vec<usize> = (0..self.width).filter(|column| !start.nameless.contains(column)).collect();
            self.refuse_text_above_number(&start, &all, Some(0))?;
        }
        let taken = start.taken_for_sizes.take();
        let Start { first, second, count, is_numbered, nameless, nameless_in_words, left_out, in_doubt, .. } = start;
        let mut columns: Vec<usize> = (0..self.width).filter(|column| !nameless.contains(column)).collect();
        let is_header = is_numbered || opening(&first, &columns) == Opening::Header;
        let (mut names, mut others, mut header) = (Vec::new(), Vec::new(), None);
        if is_header && !is_numbered {
            header = Some(text.line(&first));
            let all = cells(&first);
            let named: Vec<String> = columns.iter().map(|&column| all[column].clone()).collect();
            let vectors =
                names::of_vectors(&named, order).map_err(|problem| problem.at(self.file, self.place(&first)))?;
            others = vectors.notes(&named);
            columns = vectors.places.iter().map(|&place| columns[place]).collect();
            names = columns.iter().map(|&column| all[column].clone()).collect();
        }
        let mut counting = Counting::new(false, is_header, &columns);
        let data = (!is_header).then_some(first).into_iter().chain(second).map(Ok);
        let (mut numbers, mut centers) = (Vec::new(), CalledCenters::default());
        for row in data.chain(records.map(|row| parsed(self.file, row))) {
            let row = row?;
            let read: Vec<f64> = columns.iter().map(|&column| self.number(&row, column)).collect::<Result<_, _>>()?;
            counting.note(read.first().copied().unwrap_or(f64::NAN));
            centers.note(&row, &columns, numbers.len(), || text.line(&row));
            push_limited(&mut numbers, read).map_err(|problem| problem.at(self.file, self.place(&row)))?;
        }
        self.check_count(count, numbers.len())?;
        let left_out = left_out.into_iter().chain(nameless_in_words).chain(text.left_out());
        let mut notes: Vec<String> = in_doubt.map(|row| row.in_words).into_iter().chain(taken).collect();
        notes.extend(left_out.map(|part| format!("left out: {part}")));
        notes.extend(others);
        notes.extend(counting.in_words(&columns, false));
        notes.extend(self.losses.in_words());
        notes.extend(self.commas()?);
        let comment_on_center = text.comment_on_center().cloned();
        Ok(Rows { names, numbers, header, centers: centers.finish(), comment_on_center, notes })
    }

    fn points(mut self, shape: &Shape, skipping: &mut Skipping) -> Result<Reading, InputError> {
        let text = self.text;
        let mut records = text.rows();
        let Some(mut start) = Start::read(self.file, text, &mut records, shape.use_of())? else {
            return Ok(Reading::without_columns(Points::Plane(Vec::new()), Vec::new()));
        };
        let taken = start.taken_for_sizes.take().map(|row| shape.advised(row, "--no-header reads it as a point"));
        self.width = start.width;
        let is_named =
            shape.columns.is_some_and(|Columns(all)| all.iter().any(|column| matches!(column, Column::Name(_))));
        let is_left_out = |column: &usize| shape.columns.is_none() && start.nameless.contains(column);
        let all: Vec<usize> = (0..start.width).filter(|column| !is_left_out(column)).collect();
        if shape.columns.is_none() && !start.is_numbered {
            self.refuse_text_above_number(&start, &all, shape.skip)?;
        }
        let columns = self.chosen(&start, shape, &all)?;
        if shape.columns.is_some() && !is_named && !start.is_numbered {
            self.refuse_text_above_number(&start, &columns, shape.skip)?;
        }

        let mut points = Points::of_dimension(columns.len()).expect("no more columns are chosen than are read");
        let Start {
            first,
            second,
            count,
            is_numbered,
            nameless,
            nameless_in_words,
            left_out: rows_left_out,
            in_doubt,
            ..
        } = start;
        let has_header = is_numbered || is_named || opening(&first, &columns) == Opening::Header;
        let names = if has_header && !is_numbered { cells(&first) } else { vec![String::new(); first.len()] };
        let data = (!has_header).then_some(first).into_iter().chain(second).map(Ok);
        let mut counting = Counting::new(shape.columns.is_some(), has_header, &columns);
        let skipped_before = skipping.count();
        for row in data.chain(records.map(|row| parsed(self.file, row))) {
            let row = row?;
            match self.point(&row, &columns) {
                Err(error) if skipping.passes_over(&error.problem, points.len()) => {}
                point => {
                    let (point, dimension) = (point?, columns.len());
                    counting.note(point[0]);
                    let pushed = points.push(&point[..dimension]);
                    pushed.map_err(|problem| problem.at(self.file, self.place(&row)))?;
                }
            }
        }
        self.check_count(count, points.len() + skipping.count() - skipped_before)?;
        let read = in_doubt
            .map(|RowInDoubt { in_words, line }| shape.advised(in_words, &format!("--skip {line} leaves it out")));
        let mut notes: Vec<String> = read.into_iter().chain(taken).collect();
        notes.extend(counting.in_words(&columns, true));
        if shape.columns.is_none() {
            let used: Vec<String> = columns.iter().map(|&column| names[column].clone()).collect();
            notes.extend(names::in_another_order(&used));
        }
        if shape.is_cloud && shape.columns.is_none() && !has_header && columns == [0, 1, 2] && names.len() >= 4 {
            let remark = "columns 1, 2, 3 are read as coordinates; if column 1 holds atomic numbers, --columns 2,3,4 \
                          leaves it out";
            notes.extend(may_be_atoms(&points).then(|| remark.to_owned()));
        }
        let losses = self.losses.in_words();
        notes.extend(self.commas()?);
        let (columns, mut left_out) = columns_of(&names, &columns);
        for (column, in_words) in nameless.iter().zip(nameless_in_words) {
            let plain = format!("column {}", column + 1);
            if let Some(part) = left_out.iter_mut().find(|part| **part == plain) {
                *part = in_words;
            }
        }
        left_out.extend(rows_left_out);
        Ok(Reading { notes, losses, ..Reading::of(points, (columns, left_out)) })
    }

    fn point(&mut self, row: &ByteRecord, columns: &[usize]) -> Result<[f64; COORDINATE_LIMIT], InputError> {
        let mut point = [0.0; COORDINATE_LIMIT];
        let mut missing = None;
        for (slot, &column) in point.iter_mut().zip(columns) {
            match self.number(row, column) {
                Ok(number) => *slot = number,
                Err(error) if error.problem.is_missing() => missing = missing.or(Some(error)),
                Err(error) => return Err(error),
            }
        }
        missing.map_or(Ok(point), Err)
    }

    /// Refuses a first row of data, as far as the given columns tell, with text above a number: it may be meant as a
    /// header.
    fn refuse_text_above_number(&self, start: &Start, columns: &[usize], skip: Option<u64>) -> Result<(), InputError> {
        let (first, second) = (&start.first, start.second.as_ref());
        if opening(first, columns) == Opening::Header {
            return Ok(());
        }
        let line = self.text.line(first);
        let refused = |column: usize, problem: fn(String, u64) -> Problem| {
            let text = cells(first).swap_remove(column);
            Err(problem(text, line).at(self.file, Place::Cell { line, column: column as u64 + 1 }))
        };
        if let Some(column) = text_above_number(first, second, columns.iter().copied()) {
            return refused(column, |text, skip| Problem::TextAboveNumber { text, skip, option: "--skip" });
        }
        match text_above_number(first, second, 0..first.len()) {
            Some(column) if skip.is_none() => refused(column, |text, skip| Problem::HeaderOrData { text, skip }),
            _ => Ok(()),
        }
    }

    /// The columns of the coordinates, counted from 0: those that were chosen, or a guess among those that may be.
    fn chosen(&self, start: &Start, shape: &Shape, all: &[usize]) -> Result<Vec<usize>, InputError> {
        let (first, wanted) = (&start.first, shape.wanted);
        let names = cells(first);
        let at_first = |problem: Problem| problem.at(self.file, self.place(first));
        if let Some(columns) = shape.columns {
            return names::chosen(&names, columns, &available(first)).map_err(at_first);
        }
        if let Some(columns) = names::of_coordinates(&names, wanted).map_err(at_first)? {
            return Ok(columns);
        }
        let cells = all.len();
        if shape.is_cloud {
            // A name of an atom or of a point may stand before its coordinates.
            let is_named = has_number(first) && all.first().is_some_and(|&column| is_text(&first[column]));
            let all = &all[usize::from(is_named)..];
            let coordinates = all.len().min(3);
            if wanted == Wanted::Planar && coordinates > 2 {
                return Err(at_first(Problem::ThirdCoordinate));
            }
            if wanted.takes_all(coordinates, false) {
                return Ok(all[..coordinates].to_vec());
            }
        }
        let numbers = all.iter().filter(|&&column| is_number(&first[column])).count();
        // There is something to choose only where numbers are left beside the text.
        let of_text = column_of_text(first, start.second.as_ref()).filter(|_| numbers >= 2);
        if wanted.takes_all(cells, !has_number(first)) && of_text.is_none() {
            return Ok(all.to_vec());
        }
        let wanted = wanted.in_words();
        // A row with numbers is no header, so a text in it is data.
        let text = of_text.or(first.iter().position(is_text).filter(|_| numbers >= 1));
        if let Some(column) = text {
            let place = Place::Cell { line: self.text.line(first), column: column as u64 + 1 };
            let text = names[column].clone();
            if self.text.separator() == b',' && joins_digits(&text) {
                return Err(Problem::BetweenCommas(text).at(self.file, place));
            }
            return Err(Problem::TextAmongNumbers { text, cells, wanted }.at(self.file, place));
        }
        let problem = match cells {
            1 => Problem::OneColumn(on_one_column(self.text, first)),
            _ if may_be_halves(first, self.text.separator()) => Problem::HalvesOrColumns { cells, wanted },
            _ => {
                let sample = start.second.as_ref().unwrap_or(first);
                let holds_number = |column: &usize| sample.get(*column).is_some_and(is_number);
                let named = if has_number(first) { vec![String::new(); names.len()] } else { names };
                let columns = names::advised(&named, all.iter().copied().filter(holds_number));
                Problem::ChooseColumns { cells, wanted, columns }
            }
        };
        Err(problem.at(self.file, Place::File))
    }

    fn number(&mut self, row: &ByteRecord, column: usize) -> Result<f64, InputError> {
        let text = self.text;
        let cell_at = |column: usize| Place::Cell { line: text.line(row), column: column as u64 + 1 };
        let found = self.cells_of(row);
        if found != self.width {
            let expected = self.width;
            let is_filled = row.iter().all(|cell| !cell.trim_ascii().is_empty());
            let is_twice = text.separator() == b',' && found == 2 * expected && is_filled;
            let problem =
                if is_twice { Problem::TwiceAsMany { found, expected } } else { Problem::Ragged { found, expected } };
            return Err(problem.at(self.file, cell_at(found.min(expected))));
        }
        let read = self.decimals.read(&row[column], text.separator(), || cell_at(column));
        let number = read.map_err(|problem| problem.at(self.file, cell_at(column)))?;
        self.losses.note(&row[column], number, || cell_at(column));
        Ok(number)
    }

    /// The cells of a row without the empty one after a separator at its end.
    fn cells_of(&self, row: &ByteRecord) -> usize {
        let is_trailing = row.len() == self.width + 1 && row[self.width].trim_ascii().is_empty();
        row.len() - usize::from(is_trailing)
    }

    /// Refuses a table whose first line counts other points than it has.
    fn check_count(&self, counted: Option<u64>, found: usize) -> Result<(), InputError> {
        let found = found as u64;
        match counted.filter(|&counted| counted != found) {
            Some(counted) => Err(Problem::Count { counted, found }.at(self.file, Place::File)),
            None => Ok(()),
        }
    }

    /// The remark on decimal commas, unless they leave a doubt.
    fn commas(self) -> Result<Option<String>, InputError> {
        self.decimals.finish().map_err(|(problem, place)| problem.at(self.file, place))
    }

    /// The line of a row.
    fn place(&self, row: &ByteRecord) -> Place {
        Place::Line(self.text.line(row))
    }
}

#[cfg(test)]
mod tests;
