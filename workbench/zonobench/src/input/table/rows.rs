//! The rows of a table as the reader of CSV has them.

use super::super::error::{InputError, Place, Problem};
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

/// Whether a cell beside these columns calls the row a centre.
pub(super) fn is_called_center(row: &ByteRecord, columns: &[usize]) -> bool {
    let is_center = |cell: &[u8]| {
        let cell = cell.trim_ascii();
        cell.eq_ignore_ascii_case(b"center") || cell.eq_ignore_ascii_case(b"centre")
    };
    row.iter().enumerate().any(|(column, cell)| !columns.contains(&column) && is_center(cell))
}
