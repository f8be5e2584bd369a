//! The first rows of a table, with what stands before the data: a count of points, a title, names of columns; and the
//! column that counts the rows.

use std::path::Path;

use csv::ByteRecord;

use super::header::{has_number, is_nameless, is_text, lone_count, numbers_columns};
use super::rows::{cells, parsed};
use super::text::Text;
use crate::input::error::InputError;
use crate::input::number;

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
    /// Whether the first column has no name and counts the rows.
    pub(super) has_index: bool,
    /// The rows that were left out.
    pub(super) left_out: Vec<String>,
    /// A first row that is read as data, though it may number the columns.
    pub(super) in_doubt: Option<RowInDoubt>,
    /// The rows of the text before the second one.
    before_second: usize,
}

/// A row that is read as data, though it may be a header.
pub(super) struct RowInDoubt {
    /// Its cells.
    pub(super) row: String,
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
        is_told: bool,
    ) -> Result<Option<Self>, InputError> {
        let mut next = || records.next().map(|row| parsed(file, row)).transpose();
        let Some(mut first) = next()? else { return Ok(None) };
        let mut second = next()?;
        let (mut count, mut before_second) = (None, 1);
        let mut left_out = Vec::new();
        let holds_several = |row: &ByteRecord| row.iter().filter(|cell| !cell.trim_ascii().is_empty()).count() > 1;
        if let Some(counted) = lone_count(&first)
            && let Some(row) = second.take_if(|row| holds_several(row))
        {
            left_out.push(format!("the first row, which counts {counted} points"));
            (first, second, count) = (row, next()?, Some(counted));
            before_second += 1;
            // Lists of atoms have a title behind the count.
            if text.rows().count() as u64 == counted.saturating_add(2)
                && let Some(row) = second.take()
            {
                left_out.push("the second row, a title".to_owned());
                (first, second) = (row, next()?);
                before_second += 1;
            }
        } else if let Some(counted) = second.as_ref().and_then(lone_count)
            && !has_number(&first)
            && holds_several(&first)
        {
            left_out.push(format!("the second row, which counts {counted} points"));
            (second, count) = (next()?, Some(counted));
            before_second += 1;
        }
        let (is_numbered, has_index, width, in_doubt) = (false, false, 0, None);
        let mut start = Self { first, second, width, count, is_numbered, has_index, left_out, in_doubt, before_second };
        start.name_first_column(text);
        start.cut();
        start.tell_numbered_columns(text, is_told);
        start.has_index =
            is_nameless(&start.first) && (start.is_numbered || !has_number(&start.first)) && start.counts_rows(text);
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
    fn tell_numbered_columns(&mut self, text: &Text, is_told: bool) {
        if is_told || self.second.is_none() || !numbers_columns(&self.first) {
            return;
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
        let row = cells(&self.first).join(", ");
        if self.is_numbered {
            self.left_out.push(format!("the first row ({}), which numbers the columns", row.trim_start_matches(", ")));
        } else {
            self.in_doubt = Some(RowInDoubt { row, line: text.line(&self.first) });
        }
    }

    /// Whether the first column counts the rows, from 0 or 1 on.
    fn counts_rows(&self, text: &Text) -> bool {
        let number = |row: &ByteRecord| std::str::from_utf8(row.get(0)?).ok()?.trim().parse::<u64>().ok();
        let Some(begin) = self.second.as_ref().and_then(number).filter(|&begin| begin <= 1) else { return false };
        (begin..).zip(self.rows_behind(text)).all(|(place, row)| number(&row) == Some(place))
    }
}

fn ends_empty(row: &ByteRecord) -> bool {
    row.len() > 1 && row[row.len() - 1].trim_ascii().is_empty()
}
