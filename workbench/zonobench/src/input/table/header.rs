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
pub(super) fn opening(first: &ByteRecord, second: Option<&ByteRecord>, chosen: &[usize]) -> Opening {
    let cells = || chosen.iter().filter_map(|&column| first.get(column));
    let has_number = cells().any(|cell| parse(cell).is_some());
    if cells().any(|cell| is_broken_number(cell, has_number)) {
        return Opening::Data;
    }
    if cells().any(|cell| parse(cell).is_none() && !cell.trim_ascii().is_empty()) {
        return Opening::Header;
    }
    let mut pairs = first.iter().zip(second.into_iter().flatten());
    let is_text = |cell: &[u8]| parse(cell).is_none() && !cell.trim_ascii().is_empty();
    if pairs.any(|(above, below)| is_text(above) && parse(below).is_some()) { Opening::Unclear } else { Opening::Data }
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
    }
}
