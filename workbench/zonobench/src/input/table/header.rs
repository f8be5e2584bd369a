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

/// Whether the first cell of a header has no name.
pub(super) fn is_nameless(header: &ByteRecord) -> bool {
    header.get(0).is_some_and(is_no_name)
}

/// Whether a cell of a header is empty, or holds what a program writes there for want of a name.
pub(super) fn is_no_name(cell: &[u8]) -> bool {
    let cell = cell.trim_ascii();
    let number = cell.strip_prefix(b"Unnamed: ");
    cell.is_empty() || number.is_some_and(|number| !number.is_empty() && number.iter().all(u8::is_ascii_digit))
}

/// Whether a cell is no number, but begins like one; where no number stands in the row, whether it is no name.
fn is_broken_number(cell: &[u8], is_beside_number: bool) -> bool {
    let cell = cell.trim_ascii();
    let unsigned = cell.strip_prefix(b"-").or(cell.strip_prefix(b"+")).unwrap_or(cell);
    let digits = unsigned.strip_prefix(b".").unwrap_or(unsigned);
    let begins_like_number = digits.first().is_some_and(u8::is_ascii_digit);
    let is_broken = if is_beside_number { begins_like_number } else { !cell.is_empty() && !is_name(cell) };
    !is_number(cell) && is_broken
}

/// Whether a cell may be the name of a column: it has a letter, and no digit of any script stands before the first one,
/// but for ordinals such as `1st`. Digits and points among letters that look like digits are no name.
fn is_name(cell: &[u8]) -> bool {
    const LOOK_ALIKES: &str = "lIOo.,+-";
    let text = String::from_utf8_lossy(cell);
    let is_letter = |c: char| c.is_alphabetic() || c == char::REPLACEMENT_CHARACTER;
    let Some(begin) = text.find(|c: char| c.is_numeric() || is_letter(c)) else { return false };
    let word = &text[begin..];
    if word.starts_with(is_letter) {
        let is_like_number = text.chars().all(|c| c.is_ascii_digit() || LOOK_ALIKES.contains(c));
        return !(is_like_number && text.contains(['.', ',']) && text.contains(|c: char| c.is_ascii_digit()));
    }
    let rest = word.trim_start_matches(|c: char| c.is_ascii_digit());
    begin == 0 && ["st", "nd", "rd", "th"].iter().any(|ending| rest.to_ascii_lowercase().starts_with(ending))
}

/// Whether all cells of a row that are not empty are names of columns, and there is one.
pub(super) fn holds_names(row: &ByteRecord) -> bool {
    let mut filled = row.iter().filter(|cell| !cell.trim_ascii().is_empty()).peekable();
    filled.peek().is_some() && filled.all(|cell| !is_number(cell) && is_name(cell))
}

/// Whether the first line that is not blank is that of a grid of heights, whichever lines are to be left out.
pub(super) fn is_grid(text: &[u8]) -> bool {
    let first = text.trim_ascii_start().split(|byte| byte.is_ascii_whitespace()).next();
    first.is_some_and(|word| word.eq_ignore_ascii_case(b"ncols"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_cannot_be_data() {
        let told = |first: &[&str], chosen: &[usize]| opening(&ByteRecord::from(first.to_vec()), chosen);
        for header in [["x", "y"], ["", "y"], ["1st", "2nd"], ["e1", "e2"], ["x [m]", "y [m]"], ["Ölwert", "größe"]]
        {
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
            ["\u{2212}1", "\u{2212}1"],
            ["1/2", "1/3"],
            ["1D0", "2D0"],
            ["1m", "2m"],
            ["0x10", "0x20"],
            ["$10", "$20"],
            ["5\u{b1}0.1", "6\u{b1}0.1"],
            ["(1", "2)"],
            ["1+2j", "1+0j"],
            ["\u{ff11}", "\u{ff12}"],
            ["\u{661}", "\u{662}"],
            ["l.5", "O.5"],
            ["--", "--"],
            ["-", "+"],
            ["?", "?"],
            ["****", "****"],
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
