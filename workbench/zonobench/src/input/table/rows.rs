//! The rows of a table as the reader of CSV has them.

use super::super::error::{InputError, Place, Problem};
use super::super::names::bodies::{is_center, is_letter_beside_c, is_letter_c};
use csv::ByteRecord;
use std::path::Path;

/// The row, if it parses.
pub(super) fn parsed(file: &Path, row: csv::Result<ByteRecord>) -> Result<ByteRecord, InputError> {
    row.map_err(|error| Problem::Table(error.to_string()).at(file, Place::File))
}

/// The cells of a row as text, without the space around them.
pub(super) fn cells(row: &ByteRecord) -> Vec<String> {
    row.iter().map(|cell| String::from_utf8_lossy(cell).trim().to_owned()).collect()
}

/// The rows that a cell beside their numbers calls a centre.
#[derive(Debug, Default)]
pub(super) struct CalledCenters {
    /// Those by a word, and those by the letter c, each the first two, by their places with their lines.
    by_word: Vec<(usize, u64)>,
    by_letter: Vec<(usize, u64)>,
    /// Whether rows are called by other letters, so that c is one of these.
    is_lettered: bool,
}

impl CalledCenters {
    /// Takes note of a row of which these columns are numbers.
    pub(super) fn note(&mut self, row: &ByteRecord, columns: &[usize], place: usize, line: impl Fn() -> u64) {
        for (_, cell) in row.iter().enumerate().filter(|(column, _)| !columns.contains(column)) {
            let name = String::from_utf8_lossy(cell);
            self.is_lettered |= is_letter_beside_c(&name);
            let called = if is_letter_c(&name) { &mut self.by_letter } else { &mut self.by_word };
            if called.len() < 2 && is_center(&name) {
                called.push((place, line()));
            }
        }
    }

    /// The first rows that are called a centre, in their order: two show that there is more than one.
    pub(super) fn finish(mut self) -> Vec<(usize, u64)> {
        if !self.is_lettered {
            self.by_word.append(&mut self.by_letter);
        }
        self.by_word.sort_unstable();
        self.by_word.dedup();
        self.by_word
    }
}
