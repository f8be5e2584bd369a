//! Whether the first row of a table is a header, told from what its cells look like.

use csv::ByteRecord;

/// What a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Opening {
    /// A header: it cannot be data.
    Header,
    /// Data, broken ones included.
    Data,
    /// Data as far as the chosen columns tell, but another column has text here and a number below.
    Unclear,
}

/// What the first row is, of which the given columns are read.
///
/// Text in a row with numbers makes no header of it where the second row has text in the same column, or where there is
/// no second row: then that is a column of text, and the row is data with it.
pub(super) fn opening(first: &ByteRecord, second: Option<&ByteRecord>, chosen: &[usize]) -> Opening {
    let has_number = first.iter().any(|cell| parse(cell).is_some());
    let cell = |column: usize| first.get(column).unwrap_or_default();
    let is_data = |&column: &usize| {
        is_broken_number(cell(column), has_number) || has_number && is_column_of_text(first, second, column)
    };
    if chosen.iter().any(is_data) {
        return Opening::Data;
    }
    if chosen.iter().any(|&column| is_text(cell(column))) {
        return Opening::Header;
    }
    let mut pairs = first.iter().zip(second.into_iter().flatten());
    if pairs.any(|(above, below)| is_text(above) && parse(below).is_some()) { Opening::Unclear } else { Opening::Data }
}

/// The first column of text beside numbers, if the first row is one of data; a broken number is no text.
pub(super) fn column_of_text(first: &ByteRecord, second: Option<&ByteRecord>) -> Option<usize> {
    let has_number = first.iter().any(|cell| parse(cell).is_some());
    let is_text = |&column: &usize| is_column_of_text(first, second, column) && !is_broken_number(&first[column], true);
    (0..first.len()).find(is_text).filter(|_| has_number)
}

/// Whether the rows have text in a column: the second one, too, if there is one.
fn is_column_of_text(first: &ByteRecord, second: Option<&ByteRecord>, column: usize) -> bool {
    let has_text = |row: &ByteRecord| row.get(column).is_some_and(is_text);
    has_text(first) && second.is_none_or(has_text)
}

/// Whether a cell holds something else than a number.
pub(super) fn is_text(cell: &[u8]) -> bool {
    parse(cell).is_none() && !cell.trim_ascii().is_empty()
}

/// The number in a cell, not necessarily finite.
pub(super) fn parse(cell: &[u8]) -> Option<f64> {
    std::str::from_utf8(cell).ok()?.trim().parse().ok()
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
    parse(cell).is_none() && begins_like_number && (is_spelled_like_number || is_beside_number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_cannot_be_data() {
        let told = |first: &[&str], second: &[&str], chosen: &[usize]| {
            opening(&ByteRecord::from(first.to_vec()), Some(&ByteRecord::from(second.to_vec())), chosen)
        };
        for header in [["x", "y"], ["", "y"], ["1st", "2nd"], ["north", "5"], ["e1", "e2"], ["-", "+"]] {
            assert_eq!(told(&header, &["1", "2"], &[0, 1]), Opening::Header, "{header:?}");
        }
        for data in
            [["1", "2"], ["1.2.3", "4"], ["1,5e", "2,5e"], ["1.5m", "2"], ["", "2"], ["nan", "inf"], ["-.5.", "1e"]]
        {
            assert_eq!(told(&data, &["1", "2"], &[0, 1]), Opening::Data, "{data:?}");
        }
        assert_eq!(told(&["150", "4", "setosa"], &["5.1", "3.5", "0"], &[0, 1]), Opening::Unclear);
        assert_eq!(told(&["150", "4", "setosa"], &["5.1", "3.5", "virginica"], &[0, 1]), Opening::Data);
        let told = |first: &[&str], second: Option<&[&str]>| {
            let second = second.map(|second| ByteRecord::from(second.to_vec()));
            opening(&ByteRecord::from(first.to_vec()), second.as_ref(), &[0, 1])
        };
        assert_eq!(told(&["5", "north"], Some(&["6", "south"])), Opening::Data);
        assert_eq!(told(&["5", "north"], None), Opening::Data);
        assert_eq!(told(&["5", "north"], Some(&["6", "7"])), Opening::Header);
        assert_eq!(told(&["city", "size"], Some(&["Rome", "7"])), Opening::Header);
        assert_eq!(told(&["city", "size"], None), Opening::Header);
        assert_eq!(told(&["5km", "2nd", "7"], Some(&["6", "7", "8"])), Opening::Data);
    }
}
