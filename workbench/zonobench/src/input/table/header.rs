//! Whether the first row of a table is a header, told from what its cells look like.

use csv::ByteRecord;

use crate::input::number::is_number;

/// The kind of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Opening {
    /// A header: it cannot be data.
    Header,
    /// Data, broken ones included.
    Data,
}

/// The kind of the first row, of which the given columns are read. A number anywhere in it makes it data.
pub(super) fn opening(first: &ByteRecord, chosen: &[usize]) -> Opening {
    let cell = |column: usize| first.get(column).unwrap_or_default();
    let has_number = has_number(first);
    let is_data = has_number || chosen.iter().any(|&column| is_broken_number(cell(column), has_number));
    if !is_data && chosen.iter().any(|&column| is_text(cell(column))) { Opening::Header } else { Opening::Data }
}

/// The first of the columns, counted from 0, in which the first row has text and the second one a number, so that the
/// first row may be meant as a header; a broken number is no text where there are numbers in the row.
pub(super) fn text_above_number(
    first: &ByteRecord,
    second: Option<&ByteRecord>,
    mut columns: impl Iterator<Item = usize>,
) -> Option<usize> {
    let has_number = has_number(first);
    let has_text = |column| first.get(column).is_some_and(|cell| is_text(cell) && !is_broken_number(cell, has_number));
    let is_above_number = |column| second.and_then(|second| second.get(column)).is_some_and(is_number);
    columns.find(|&column| has_text(column) && is_above_number(column))
}

/// The first column of text beside numbers, if the first row is one of data; a broken number is no text.
pub(super) fn column_of_text(first: &ByteRecord, second: Option<&ByteRecord>) -> Option<usize> {
    let is_text = |&column: &usize| is_column_of_text(first, second, column) && !is_broken_number(&first[column], true);
    (0..first.len()).find(is_text).filter(|_| has_number(first))
}

/// Whether the rows have text in a column: the second one, too, if there is one.
fn is_column_of_text(first: &ByteRecord, second: Option<&ByteRecord>, column: usize) -> bool {
    let has_text = |row: &ByteRecord| row.get(column).is_some_and(is_text);
    has_text(first) && second.is_none_or(has_text)
}

/// Whether some cell of a row is a number.
pub(super) fn has_number(row: &ByteRecord) -> bool {
    row.iter().any(is_number)
}

/// Whether a cell holds something else than a number.
pub(super) fn is_text(cell: &[u8]) -> bool {
    !is_number(cell) && !cell.trim_ascii().is_empty()
}

/// The whole number that stands alone in a row.
pub(super) fn lone_count(row: &ByteRecord) -> Option<u64> {
    let only = row.get(0).filter(|_| row.len() == 1)?;
    std::str::from_utf8(only).ok()?.trim().parse().ok()
}

/// Whether the cells are the numbers from 0 on, two or more, as programs write them in place of missing names; an
/// empty first cell stands above the numbers of rows.
pub(super) fn numbers_columns(row: &ByteRecord) -> bool {
    let names: Vec<&[u8]> = row.iter().skip(usize::from(is_nameless(row))).map(<[u8]>::trim_ascii).collect();
    let is_place = |(place, name): (usize, &&[u8])| **name == *place.to_string().as_bytes();
    (names.len() >= 2 || (is_nameless(row) && !names.is_empty())) && names.iter().enumerate().all(is_place)
}

/// Whether the first cell of a header has no name, or the one that a program gave it for want of another.
pub(super) fn is_nameless(header: &ByteRecord) -> bool {
    header.get(0).is_some_and(|name| matches!(name.trim_ascii(), b"" | b"Unnamed: 0"))
}

/// Whether a cell is no number, but begins like one and holds nothing but the letters of numbers, or stands in a row
/// with numbers.
fn is_broken_number(cell: &[u8], is_beside_number: bool) -> bool {
    const LETTERS_OF_NUMBERS: &[u8] = b"0123456789+-.,eE_' ";
    let cell = cell.trim_ascii();
    let unsigned = cell.strip_prefix(b"-").or(cell.strip_prefix(b"+")).unwrap_or(cell);
    let digits = unsigned.strip_prefix(b".").unwrap_or(unsigned);
    let begins_like_number = digits.first().is_some_and(u8::is_ascii_digit);
    let is_spelled_like_number = cell.iter().all(|letter| LETTERS_OF_NUMBERS.contains(letter));
    !is_number(cell) && begins_like_number && (is_spelled_like_number || is_beside_number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_cannot_be_data() {
        let told = |first: &[&str], chosen: &[usize]| opening(&ByteRecord::from(first.to_vec()), chosen);
        for header in [["x", "y"], ["", "y"], ["1st", "2nd"], ["e1", "e2"], ["-", "+"], ["city", "size"]] {
            assert_eq!(told(&header, &[0, 1]), Opening::Header, "{header:?}");
        }
        for data in [
            ["1", "2"],
            ["1.2.3", "4"],
            ["1,5e", "2,5e"],
            ["1.5m", "2"],
            ["", "2"],
            ["nan", "inf"],
            ["-.5.", "1e"],
            ["north", "5"],
            ["5", "north"],
        ] {
            assert_eq!(told(&data, &[0, 1]), Opening::Data, "{data:?}");
        }
        assert_eq!(told(&["150", "4", "setosa"], &[0, 1]), Opening::Data);
        assert_eq!(told(&["5km", "2nd", "7"], &[0, 1]), Opening::Data);
        assert_eq!(told(&["north", "south", "2024"], &[0, 1]), Opening::Data);
    }

    #[test]
    fn text_above_a_number_may_be_a_header() {
        let told = |first: &[&str], second: &[&str]| {
            let (first, second) = (ByteRecord::from(first.to_vec()), ByteRecord::from(second.to_vec()));
            text_above_number(&first, Some(&second), 0..first.len())
        };
        assert_eq!(told(&["1", "2", "north"], &["3", "4", "5"]), Some(2));
        assert_eq!(told(&["1", "2", "north"], &["3", "4", "south"]), None);
        assert_eq!(told(&["1", "2", "north"], &["3", "4"]), None);
        assert_eq!(told(&["1", "2", "3km"], &["3", "4", "5"]), None);
        let alone = ByteRecord::from(vec!["5", "north"]);
        assert_eq!(text_above_number(&alone, None, 0..2), None);
    }
}
