//! The separator of the cells of a table, told from its first rows.

use csv::{ByteRecord, ReaderBuilder};

use crate::input::number;

/// The separators, in the order in which they are taken where several explain a table equally well. A space stands
/// for any number of spaces and tabs.
const SEPARATORS: [u8; 5] = [b',', b';', b'\t', b'|', b' '];

/// Rows that are looked at.
const SAMPLE: usize = 32;

/// The separator with which the largest share of the cells behind the first row, which may be a header, are numbers.
/// A cell may have a decimal comma where commas do not separate.
pub(super) fn of(content: &[u8]) -> u8 {
    let mut best: Option<(u8, f64)> = None;
    for separator in SEPARATORS.into_iter().filter(|&separator| occurs(content, separator)) {
        let share = share_of_numbers(content, separator);
        if let Some(share) = share.filter(|&share| best.is_none_or(|(_, most)| share > most)) {
            best = Some((separator, share));
        }
    }
    best.map_or(b',', |(separator, _)| separator)
}

/// Whether a separator is anywhere in a text: one that is not makes no table, and a reader that would show this costs
/// more than a look through a small file.
fn occurs(content: &[u8], separator: u8) -> bool {
    content.contains(&separator) || (separator == b' ' && content.contains(&b'\t'))
}

/// The share of numbers among the cells that are not empty; `None` if nothing is separated.
fn share_of_numbers(content: &[u8], separator: u8) -> Option<f64> {
    let rows: Vec<ByteRecord> = records(content, separator).filter_map(Result::ok).take(SAMPLE).collect();
    if rows.iter().all(|row| row.len() < 2) {
        return None;
    }
    let behind_first = if rows.len() > 1 { &rows[1..] } else { &rows[..] };
    let filled = behind_first.iter().flatten().filter(|cell| !cell.trim_ascii().is_empty());
    let (mut cells, mut numbers) = (0.0, 0.0);
    for cell in filled {
        cells += 1.0;
        numbers += f64::from(u8::from(number::is_number(cell)));
    }
    Some(if cells > 0.0 { numbers / cells } else { 0.0 })
}

/// The rows of a table that are not blank.
pub(super) fn records(content: &[u8], separator: u8) -> impl Iterator<Item = csv::Result<ByteRecord>> {
    let mut builder = ReaderBuilder::new();
    builder.has_headers(false).flexible(true).delimiter(separator);
    let is_blank = |row: &ByteRecord| row.is_empty() || (row.len() == 1 && row[0].trim_ascii().is_empty());
    let words = move |row: ByteRecord| if separator == b' ' { of_words(&row) } else { row };
    let records = builder.from_reader(content).into_byte_records();
    records.map(move |row| row.map(words)).filter(move |row| !row.as_ref().is_ok_and(is_blank))
}

/// A row of words between any number of spaces and tabs, up to a comment.
fn of_words(row: &ByteRecord) -> ByteRecord {
    let words = row.iter().flat_map(|cell| cell.split(|&byte| byte == b'\t'));
    let filled = words.filter(|word| !word.trim_ascii().is_empty());
    let mut words: ByteRecord = filled.take_while(|word| !word.starts_with(b"#")).collect();
    words.set_position(row.position().cloned());
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_separator_makes_numbers_of_the_cells() {
        for (content, expected) in [
            ("1,2\n3,4\n", b','),
            ("x;y\n0,5;0,5\n1,5;0,5\n", b';'),
            ("0,5;0,5\n", b';'),
            ("0,5|0,5\n1,5|2,5\n", b'|'),
            ("a|b,1,2\nc|d,3,4\n", b','),
            ("0,5\t1,5\n", b'\t'),
            ("1\t2 3\n4 5\t6\n", b' '),
            ("New York\t1\t2\nLos Angeles\t3\t4\n", b'\t'),
            ("x y\n1 2\n3 4", b' '),
            ("a, b\n1, 2\n", b','),
            ("n;m,x,y\na;b,1,2\nc;d,3,4\n", b','),
            ("0,5 1,5\n2,5 3,5\n", b' '),
            ("1 234\t5 678\n", b'\t'),
            ("7\n8\n", b','),
            ("a b\n", b' '),
            ("a;b\n", b';'),
        ] {
            assert_eq!(char::from(of(content.as_bytes())), char::from(expected), "{content}");
        }
    }
}
