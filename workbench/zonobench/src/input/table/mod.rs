//! Points from a table of separated cells.

mod header;
mod text;

use std::path::Path;

use csv::ByteRecord;

use self::header::{Opening, column_of_text, is_text, opening, parse, text_above_number};
use self::text::Text;
use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem};
use super::points::{COORDINATE_LIMIT, Points, Wanted};
use super::push_limited;
use super::reading::{Reading, columns_of};

/// Pairs of header names that are taken for coordinates when no columns are chosen, in the order first, second
/// coordinate.
const KNOWN_NAMES: [[&str; 2]; 6] =
    [["x", "y"], ["lon", "lat"], ["lng", "lat"], ["long", "lat"], ["longitude", "latitude"], ["easting", "northing"]];

/// Names of three coordinates, which come before pairs.
const SPACE_NAMES: [&str; 3] = ["x", "y", "z"];

/// Reads the points of a table.
///
/// The first row is a header if the chosen columns are named, or if it cannot be data: it has no number, and some
/// chosen cell is text that does not look like a broken number. Where a row with numbers has text above a number, it
/// is refused: in a chosen column the text is no number, elsewhere the caller says by `skip`, the number of lines to
/// leave out at the start, whether it is a header.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    skip: Option<u64>,
    wanted: Wanted,
) -> Result<Reading, InputError> {
    let text = Text::new(content, skip.unwrap_or(0));
    let mut reading = Table { file, text: &text, columns: Vec::new(), width: 0 }.points(columns, skip, wanted)?;
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
}

impl Rows {
    /// Whether the header names coordinates, so that the rows may be meant as points.
    pub(super) fn are_named_as_points(&self) -> bool {
        let has = |name: &str| self.names.iter().any(|other| other.eq_ignore_ascii_case(name));
        KNOWN_NAMES.iter().any(|pair| pair.iter().all(|name| has(name)))
    }
}

/// Reads all the numbers of a table, row by row: rows of the same length, after a header line that is recognised as
/// above.
pub(super) fn rows(file: &Path, content: &[u8]) -> Result<Rows, InputError> {
    let text = Text::new(content, 0);
    Table { file, text: &text, columns: Vec::new(), width: 0 }.numbers()
}

struct Table<'a> {
    file: &'a Path,
    text: &'a Text<'a>,
    /// The chosen columns, counted from 0.
    columns: Vec<usize>,
    /// The cells of a row, an empty one after a trailing separator apart.
    width: usize,
}

/// The first two rows.
type Start = (ByteRecord, Option<ByteRecord>);

impl Table<'_> {
    fn numbers(mut self) -> Result<Rows, InputError> {
        let mut records = self.text.rows();
        let Some((first, second)) = self.start(&mut records)? else {
            return Ok(Rows::default());
        };
        self.columns = (0..self.width).collect();
        let is_header = opening(&first, &self.columns) == Opening::Header;
        let names = if is_header { cells(&first) } else { Vec::new() };
        let data = (!is_header).then_some(first).into_iter().chain(second).map(Ok);
        let mut rows = Vec::new();
        for row in data.chain(records.map(|row| self.parsed(row))) {
            let row = row?;
            let numbers: Result<Vec<f64>, InputError> =
                (0..row.len().max(1)).map(|column| self.number(&row, column)).collect();
            push_limited(&mut rows, numbers?).map_err(|problem| problem.at(self.file, self.place(&row)))?;
        }
        Ok(Rows { names, numbers: rows })
    }

    fn points(mut self, columns: Option<&Columns>, skip: Option<u64>, wanted: Wanted) -> Result<Reading, InputError> {
        let mut records = self.text.rows();
        let Some((first, second)) = self.start(&mut records)? else {
            return Ok(Reading::without_columns(Points::Plane(Vec::new()), Vec::new()));
        };
        let is_named = columns.is_some_and(|Columns(all)| all.iter().any(|column| matches!(column, Column::Name(_))));
        if columns.is_none() {
            let all: Vec<usize> = (0..first.len()).collect();
            self.refuse_text_above_number(&first, second.as_ref(), &all, skip)?;
        }
        self.columns = self.chosen(&first, second.as_ref(), columns, wanted)?;
        if columns.is_some() && !is_named {
            self.refuse_text_above_number(&first, second.as_ref(), &self.columns, skip)?;
        }

        let mut points = Points::of_dimension(self.columns.len()).expect("no more columns are chosen than are read");
        let has_header = is_named || opening(&first, &self.columns) == Opening::Header;
        let names: Vec<String> = if has_header { cells(&first) } else { vec![String::new(); first.len()] };
        let data = (!has_header).then_some(first).into_iter().chain(second).map(Ok);
        for row in data.chain(records.map(|row| self.parsed(row))) {
            let row = row?;
            let mut point = [0.0; COORDINATE_LIMIT];
            for (slot, &column) in point.iter_mut().zip(&self.columns) {
                *slot = self.number(&row, column)?;
            }
            let point = &point[..self.columns.len()];
            points.push(point).map_err(|problem| problem.at(self.file, self.place(&row)))?;
        }
        Ok(Reading::of(points, columns_of(&names, &self.columns)))
    }

    /// The first two rows, which tell the width: rows may end with a separator. A header may leave its last column
    /// without a name.
    fn start(
        &mut self,
        records: &mut impl Iterator<Item = csv::Result<ByteRecord>>,
    ) -> Result<Option<Start>, InputError> {
        let Some(first) = records.next() else {
            return Ok(None);
        };
        self.width = usize::MAX;
        let first = self.parsed(first)?;
        let second = records.next().map(|row| self.parsed(row)).transpose()?;
        let ends_empty = |row: &ByteRecord| row.len() > 1 && row[row.len() - 1].trim_ascii().is_empty();
        let is_trailing = ends_empty(&first)
            && second.as_ref().is_none_or(|second| second.len() + 1 == first.len() || ends_empty(second));
        self.width = first.len() - usize::from(is_trailing);
        Ok(Some((self.without_trailing_cell(first), second.map(|row| self.without_trailing_cell(row)))))
    }

    /// The row, if it parses.
    fn parsed(&self, row: csv::Result<ByteRecord>) -> Result<ByteRecord, InputError> {
        let row = row.map_err(|error| Problem::Table(error.to_string()).at(self.file, Place::File))?;
        Ok(self.without_trailing_cell(row))
    }

    /// The row without the empty cell after a separator at its end.
    fn without_trailing_cell(&self, mut row: ByteRecord) -> ByteRecord {
        if row.len().checked_sub(1) == Some(self.width) && row[self.width].trim_ascii().is_empty() {
            row.truncate(self.width);
        }
        row
    }

    /// Refuses a first row of data, as far as the given columns tell, with text above a number: it may be meant as a
    /// header.
    fn refuse_text_above_number(
        &self,
        first: &ByteRecord,
        second: Option<&ByteRecord>,
        columns: &[usize],
        skip: Option<u64>,
    ) -> Result<(), InputError> {
        if opening(first, columns) == Opening::Header {
            return Ok(());
        }
        let line = self.text.line(first);
        let refused = |column: usize, problem: fn(String, u64) -> Problem| {
            let text = cells(first).swap_remove(column);
            Err(problem(text, line).at(self.file, Place::Cell { line, column: column as u64 + 1 }))
        };
        if let Some(column) = text_above_number(first, second, columns.iter().copied()) {
            return refused(column, |text, skip| Problem::TextAboveNumber { text, skip });
        }
        match text_above_number(first, second, 0..first.len()) {
            Some(column) if skip.is_none() => refused(column, |text, skip| Problem::HeaderOrData { text, skip }),
            _ => Ok(()),
        }
    }

    fn chosen(
        &self,
        first: &ByteRecord,
        second: Option<&ByteRecord>,
        columns: Option<&Columns>,
        wanted: Wanted,
    ) -> Result<Vec<usize>, InputError> {
        let names = cells(first);
        let position = |wanted: &str| names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
        if let Some(Columns(chosen)) = columns {
            let place = |column: &Column| match column {
                Column::Name(name) if is_repeated(&names, name) => Err(Problem::TwoColumns(name.clone())),
                Column::Number(number) if *number <= names.len() => Ok(number - 1),
                Column::Number(number) => Err(Problem::NoColumnNumber { number: *number, cells: names.len() }),
                Column::Name(name) => position(name)
                    .ok_or_else(|| Problem::NoSuchColumn { name: name.clone(), available: names.join(", ") }),
            };
            let at_first = |problem: Problem| problem.at(self.file, self.place(first));
            return chosen.iter().map(|column| place(column).map_err(at_first)).collect();
        }
        let known = |names: &[&str]| names.iter().map(|name| position(name)).collect::<Option<Vec<usize>>>();
        let in_space = known(&SPACE_NAMES);
        if wanted == Wanted::Planar && in_space.is_some() {
            return Err(Problem::ThirdCoordinate.at(self.file, self.place(first)));
        }
        if let Some(columns) = in_space.or_else(|| KNOWN_NAMES.iter().find_map(|pair| known(pair))) {
            return match columns.iter().find(|&&column| is_repeated(&names, &names[column])) {
                Some(&column) => Err(Problem::TwoColumns(names[column].clone()).at(self.file, self.place(first))),
                None => Ok(columns),
            };
        }
        let numbers = first.iter().filter(|cell| parse(cell).is_some()).count();
        // There is something to choose only where numbers are left beside the text.
        let of_text = column_of_text(first, second).filter(|_| numbers >= 2);
        if wanted.takes_all(first.len()) && of_text.is_none() {
            return Ok((0..first.len()).collect());
        }
        let (cells, wanted) = (first.len(), wanted.in_words());
        // A row with numbers is no header, so a text in it is data.
        let text = of_text.or(first.iter().position(is_text).filter(|_| numbers >= 1));
        if let Some(column) = text {
            let place = Place::Cell { line: self.text.line(first), column: column as u64 + 1 };
            let text = names[column].clone();
            return Err(Problem::TextAmongNumbers { text, cells, wanted }.at(self.file, place));
        }
        Err(Problem::ChooseColumns { cells, wanted }.at(self.file, Place::File))
    }

    fn number(&self, row: &ByteRecord, column: usize) -> Result<f64, InputError> {
        let cell_at = |column: usize| Place::Cell { line: self.text.line(row), column: column as u64 + 1 };
        if row.len() != self.width {
            let problem = Problem::Ragged { found: row.len(), expected: self.width };
            return Err(problem.at(self.file, cell_at(row.len().min(self.width))));
        }
        let problem = match (parse(&row[column]), std::str::from_utf8(&row[column])) {
            (Some(number), _) if number.is_finite() => return Ok(number),
            (Some(_), Ok(cell)) => Problem::NotFinite(cell.trim().to_owned()),
            (None, Ok(cell)) if cell.trim().is_empty() => Problem::EmptyCell,
            (None, Ok(cell)) => Problem::NotANumber(cell.trim().to_owned()),
            (_, Err(_)) => Problem::NotText,
        };
        Err(problem.at(self.file, cell_at(column)))
    }

    /// The line of a row.
    fn place(&self, row: &ByteRecord) -> Place {
        Place::Line(self.text.line(row))
    }
}

/// The cells of a row as text, without the space around them.
fn cells(row: &ByteRecord) -> Vec<String> {
    row.iter().map(|cell| String::from_utf8_lossy(cell).trim().to_owned()).collect()
}

fn is_repeated(names: &[String], name: &str) -> bool {
    names.iter().filter(|other| other.eq_ignore_ascii_case(name)).count() > 1
}

#[cfg(test)]
mod tests;
