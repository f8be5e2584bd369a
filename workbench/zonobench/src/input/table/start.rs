//! The first rows of a table, with what stands before the data: a count of points, a title, names of columns; and the
//! column that counts the rows.

use std::path::Path;

use csv::ByteRecord;

use super::header::{has_number, holds_names, is_nameless, is_no_name, is_text, lone_count, numbers_columns};
use super::properties::columns_beside_positions;
use super::rows::{cells, parsed};
use super::text::Text;
use crate::input::error::{InputError, Place, Problem};
use crate::input::number;

/// The use of a table, as far as it says how its first row may be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// Points of a table.
    Table,
    /// A table of which the caller said how many lines are to be left out.
    Told,
    /// A cloud of points, whose columns no program numbers.
    Cloud,
    /// Vectors.
    Vectors,
}

/// The largest atomic number that an element with a name has.
pub(super) const LAST_ELEMENT: u8 = 118;

/// The first two rows of names or data, and what was found out about the table.
pub(super) struct Start {
    /// The first row, without an empty cell after a separator at its end.
    pub(super) first: ByteRecord,
    pub(super) second: Option<ByteRecord>,
    /// The cells of a row, an empty one after a trailing separator apart.
    pub(super) width: usize,
    /// The number of points that a line before them counts.
    pub(super) count: Option<u64>,
    /// Whether the first row is a header that numbers the columns.
    pub(super) is_numbered: bool,
    /// The columns without a name beside others with one: they are never coordinates.
    pub(super) nameless: Vec<usize>,
    /// The columns without a name, in words.
    pub(super) nameless_in_words: Vec<String>,
    /// Whether the first column has the atomic numbers of a list of atoms.
    has_elements: bool,
    /// Whether the title of a list of atoms says which columns are positions.
    has_properties: bool,
    /// The rows that were left out.
    pub(super) left_out: Vec<String>,
    /// A first row that is read as data, though it may be something else.
    pub(super) in_doubt: Option<RowInDoubt>,
    /// A first row that is left out as the sizes of the table, though it is as long as a point, in words.
    pub(super) taken_for_sizes: Option<String>,
    /// The rows of the text before the second one.
    before_second: usize,
}

/// A row that is read as data, though it may be a header or the sizes of the table.
pub(super) struct RowInDoubt {
    /// The row, and what else it may be, in words.
    pub(super) in_words: String,
    /// Its line in the file.
    pub(super) line: u64,
}

impl Start {
    /// Reads the first rows; `None` if there are none. Whether a row of whole numbers is a header is told only where
    /// the caller did not say how many lines to skip.
    pub(super) fn read(
        file: &Path,
        text: &Text,
        records: &mut impl Iterator<Item = csv::Result<ByteRecord>>,
        use_of: Use,
    ) -> Result<Option<Self>, InputError> {
        let mut next = || records.next().map(|row| parsed(file, row)).transpose();
        let Some(mut first) = next()? else { return Ok(None) };
        let mut second = next()?;
        let (mut count, mut before_second, mut nameless) = (None, 1, Vec::new());
        let (mut left_out, mut taken_for_sizes) = (Vec::new(), None);
        let holds_several = |row: &ByteRecord| row.iter().filter(|cell| !cell.trim_ascii().is_empty()).count() > 1;
        let counted = lone_count(&first);
        // Lists of atoms have a title behind the count, which may be empty.
        let has_title = counted.is_some_and(|counted| text.rows().count() as u64 == counted.saturating_add(2));
        let is_apart = second.as_ref().is_some_and(|second| text.line(second) > text.line(&first) + 1);
        let (mut has_elements, mut has_properties) = (false, false);
        if let Some(counted) = counted
            && let Some(row) = second.take_if(|row| has_title || holds_several(row))
        {
            left_out.push(format!("the first row, which counts {counted} points"));
            (first, second, count) = (row, next()?, Some(counted));
            before_second += 1;
            let mut beside = None;
            if has_title && let Some(row) = second.take() {
                let line = text.line(&first);
                beside = columns_beside_positions(&first).map_err(|problem| problem.at(file, Place::Line(line)))?;
                left_out.push("the second row, a title".to_owned());
                (first, second) = (row, next()?);
                before_second += 1;
            }
            has_properties = beside.is_some();
            has_elements = !has_properties
                && (has_title || is_apart)
                && numbers_elements(&first, text.rows().skip(before_second).map_while(Result::ok));
            nameless = beside.unwrap_or_else(|| if has_elements { vec![0] } else { Vec::new() });
        } else if use_of != Use::Told
            && let Some((sizes, others)) = sizes(text, &first)
        {
            let Some(row) = second.take() else { return Ok(None) };
            left_out.push(sizes);
            let numbers = cells(&first).join(", ");
            let is_as_long = first.len() == row.len();
            taken_for_sizes =
                is_as_long.then(|| format!("the first row ({numbers}) is left out as the sizes of the table"));
            nameless = others;
            (first, second) = (row, next()?);
            before_second += 1;
        } else if let Some(counted) = second.as_ref().and_then(lone_count)
            && !has_number(&first)
            && holds_several(&first)
        {
            left_out.push(format!("the second row, which counts {counted} points"));
            (second, count) = (next()?, Some(counted));
            before_second += 1;
        }
        let mut start = Self {
            first,
            second,
            width: 0,
            count,
            is_numbered: false,
            nameless,
            nameless_in_words: Vec::new(),
            has_elements,
            has_properties,
            left_out,
            in_doubt: None,
            taken_for_sizes,
            before_second,
        };
        start.name_first_column(text);
        start.cut();
        start.tell_numbered_columns(file, text, use_of)?;
        start.doubt_sizes(text, use_of);
        start.find_nameless(text);
        Ok(Some(start))
    }

    /// The rows behind the first one.
    fn rows_behind<'a>(&self, text: &'a Text) -> impl Iterator<Item = ByteRecord> + use<'a> {
        text.rows().skip(self.before_second).filter_map(Result::ok)
    }

    /// A header with a name less than there are columns leaves the first one, of names or numbers of rows, nameless.
    fn name_first_column(&mut self, text: &Text) {
        let Some(second) = &self.second else { return };
        let filled = second.len() - usize::from(ends_empty(second));
        let is_one_less = !has_number(&self.first) && !ends_empty(&self.first) && filled == self.first.len() + 1;
        if is_one_less && (is_text(&second[0]) || self.counts_rows(text)) {
            let mut first: ByteRecord = std::iter::once(&b""[..]).chain(self.first.iter()).collect();
            first.set_position(self.first.position().cloned());
            self.first = first;
        }
    }

    /// The width of the table: rows may end with a separator. A header may leave its last column without a name.
    fn cut(&mut self) {
        let (first, second) = (&self.first, self.second.as_ref());
        let is_trailing =
            ends_empty(first) && second.is_none_or(|second| second.len() + 1 == first.len() || ends_empty(second));
        self.width = first.len() - usize::from(is_trailing);
        self.first.truncate(self.width);
    }

    /// A first row 0, 1, … is a header if a nameless column stands before it, or if all other rows are fractions, and
    /// it has three numbers or a fraction such as 2.0 shows that a point would be written otherwise: a figure may well
    /// begin with the point (0, 1).
    fn tell_numbered_columns(&mut self, file: &Path, text: &Text, use_of: Use) -> Result<(), InputError> {
        if use_of == Use::Told || self.second.is_none() || !numbers_columns(&self.first) {
            return Ok(());
        }
        let row = cells(&self.first).join(", ");
        let in_doubt = |row: &str| {
            Some(RowInDoubt {
                in_words: format!("the first row ({row}) is read as data"),
                line: text.line(&self.first),
            })
        };
        if use_of == Use::Cloud {
            self.in_doubt = in_doubt(&row);
            return Ok(());
        }
        let is_fraction = |cell: &[u8]| {
            let has_mark = cell.iter().any(|byte| b".,eE".contains(byte));
            cell.trim_ascii().is_empty() || (number::is_number(cell) && (has_mark || number::number(cell).is_err()))
        };
        let (mut are_fractions, mut has_whole_fraction) = (true, false);
        for row in self.rows_behind(text) {
            are_fractions &= row.iter().all(is_fraction);
            has_whole_fraction |= row.iter().any(|cell| cell.trim_ascii_end().ends_with(b".0"));
        }
        let is_certain = self.first.len() > 2 || has_whole_fraction;
        self.is_numbered = is_nameless(&self.first) || (are_fractions && is_certain);
        if !self.is_numbered && self.first.len() > 2 && use_of == Use::Table {
            let line = text.line(&self.first);
            return Err(Problem::NumbersOrData { row, skip: line }.at(file, Place::Line(line)));
        }
        if self.is_numbered {
            self.left_out.push(format!("the first row ({}), which numbers the columns", row.trim_start_matches(", ")));
        } else {
            self.in_doubt = in_doubt(&row);
        }
        Ok(())
    }

    /// A first row of whole numbers is one of data, though the numbers may be those of the rows behind it and of
    /// their cells, unless it was left out as such.
    fn doubt_sizes(&mut self, text: &Text, use_of: Use) {
        let whole = |cell: &[u8]| std::str::from_utf8(cell).ok()?.trim().parse::<usize>().ok();
        let sizes: Option<Vec<usize>> = self.first.iter().map(whole).collect();
        let behind = self.rows_behind(text).count();
        let are_those = sizes.is_some_and(|sizes| sizes == [behind, 2] || sizes == [behind, 3, 0]);
        if use_of != Use::Told && self.in_doubt.is_none() && are_those {
            let row = cells(&self.first).join(", ");
            let in_words = format!("the first row ({row}) is read as data, though it may say the sizes of the table");
            self.in_doubt = Some(RowInDoubt { in_words, line: text.line(&self.first) });
        }
    }

    /// A column that the header leaves without a name holds numbers or names of rows.
    fn find_nameless(&mut self, text: &Text) {
        let is_header = self.is_numbered || holds_names(&self.first);
        let is_without =
            |column: &usize| self.nameless.contains(column) || (is_header && is_no_name(&self.first[*column]));
        let nameless: Vec<usize> = (0..self.width).filter(is_without).collect();
        if nameless.len() < self.width {
            let in_words = |&column: &usize| match column {
                0 if self.has_elements => "column 1, the atomic numbers".to_owned(),
                0 if self.counts_rows(text) => "column 1, which counts the rows".to_owned(),
                _ if self.has_properties => format!("column {}, beside the positions", column + 1),
                _ => format!("column {}, which has no name", column + 1),
            };
            self.nameless_in_words = nameless.iter().map(in_words).collect();
            self.nameless = nameless;
        }
    }

    /// Whether the first column counts the rows, from 0 or 1 on.
    fn counts_rows(&self, text: &Text) -> bool {
        let number = |row: &ByteRecord| std::str::from_utf8(row.get(0)?).ok()?.trim().parse::<u64>().ok();
        let Some(begin) = self.second.as_ref().and_then(number).filter(|&begin| begin <= 1) else { return false };
        (begin..).zip(self.rows_behind(text)).all(|(place, row)| number(&row) == Some(place))
    }
}

/// The number of rows above which a row that counts them is no chance.
const CERTAIN: usize = 8;

/// The number of rows of fractions from which on a row of whole numbers that counts them is no chance.
const COUNTED: usize = 3;

/// A first row of sizes in words, with the columns that hold no coordinates then: the number of rows behind it and the
/// number of their cells, perhaps a zero, or the sizes of a file of TetGen. A row as long as the others, which may be
/// the first of them, is one only between spaces, as such rows are written, and above many rows or several of
/// fractions.
fn sizes(text: &Text, first: &ByteRecord) -> Option<(String, Vec<usize>)> {
    let whole = |cell: &[u8]| std::str::from_utf8(cell).ok()?.trim().parse::<usize>().ok();
    let sizes: Vec<usize> = first.iter().map(whole).collect::<Option<_>>()?;
    let width = match *sizes.as_slice() {
        [_, width] | [_, width, 0] => width,
        [_, width, attributes @ 0..=9, markers @ 0..=1] if markers + attributes <= 9 => {
            width.checked_add(1 + attributes + markers)?
        }
        _ => return None,
    };
    if width == 0 || (width == first.len() && text.separator() != b' ') {
        return None;
    }
    let (mut count, mut are_fractions) = (0, true);
    for row in text.rows().skip(1) {
        let row = row.ok().filter(|row| row.len() == width && row.iter().all(number::is_number))?;
        let is_counted = sizes.len() < 4 || whole(&row[0]).is_some_and(|place| place == count || place == count + 1);
        count += 1;
        are_fractions &= row.iter().all(|cell| cell.iter().any(|byte| b".,eE".contains(byte)));
        if !is_counted {
            return None;
        }
    }
    let is_numbered = sizes.len() == 4 && count > 1;
    let is_certain = width != first.len() || is_numbered || (count >= COUNTED && (are_fractions || count > CERTAIN));
    let in_words = format!("the first row ({}), which says the sizes of the table", cells(first).join(", "));
    // the coordinates are not listed: a row that is a point may be read as naming any number of them
    let others = if sizes.len() < 4 { Vec::new() } else { std::iter::once(0).chain(1 + sizes[1]..width).collect() };
    (count == sizes[0] && is_certain).then_some((in_words, others))
}

/// Whether the rows begin with atomic numbers, before three coordinates.
fn numbers_elements(first: &ByteRecord, others: impl Iterator<Item = ByteRecord>) -> bool {
    let is_element = |cell: &[u8]| {
        let number = std::str::from_utf8(cell).ok().and_then(|cell| cell.trim().parse::<u8>().ok());
        number.is_some_and(|number| (1..=LAST_ELEMENT).contains(&number))
    };
    let is_atom =
        |row: &ByteRecord| row.len() >= 4 && is_element(&row[0]) && (1..4).all(|i| number::is_number(&row[i]));
    is_atom(first) && others.into_iter().all(|row| is_atom(&row))
}

fn ends_empty(row: &ByteRecord) -> bool {
    row.len() > 1 && row[row.len() - 1].trim_ascii().is_empty()
}
