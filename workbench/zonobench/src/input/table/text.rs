//! The text of a table: which of its lines hold rows, and how a row falls into cells.

use std::borrow::Cow;

use csv::{ByteRecord, Position, ReaderBuilder};

/// The text of a table, with spaces in place of the lines that hold no row: comments, and the first lines that are to
/// be skipped.
pub(super) struct Text<'a> {
    content: Cow<'a, [u8]>,
    skipped: u64,
    comments: u64,
    separator: u8,
}

impl<'a> Text<'a> {
    /// The text without its first lines.
    pub(super) fn new(content: &'a [u8], skip: u64) -> Self {
        let mut text = Self { content: Cow::Borrowed(content), skipped: 0, comments: 0, separator: b',' };
        let mut start = 0;
        for line in content.split_inclusive(|&byte| byte == b'\n') {
            let is_skipped = text.skipped < skip;
            let is_comment = line.trim_ascii_start().starts_with(b"#");
            if is_skipped || is_comment {
                text.skipped += u64::from(is_skipped);
                text.comments += u64::from(!is_skipped);
                let end = start + line.trim_ascii_end().len();
                text.content.to_mut()[start..end].fill(b' ');
            }
            start += line.len();
        }
        text.separator = separator(&text.content);
        text
    }

    /// The lines that hold no row, in words.
    pub(super) fn left_out(&self) -> Vec<String> {
        let skipped = match self.skipped {
            0 => None,
            1 => Some("the first line".to_owned()),
            count => Some(format!("the first {count} lines")),
        };
        let comments = match self.comments {
            0 => None,
            1 => Some("1 line that begins with #".to_owned()),
            count => Some(format!("{count} lines that begin with #")),
        };
        skipped.into_iter().chain(comments).collect()
    }

    /// The rows that are not blank.
    pub(super) fn rows(&self) -> impl Iterator<Item = csv::Result<ByteRecord>> {
        let mut builder = ReaderBuilder::new();
        builder.has_headers(false).flexible(true).delimiter(self.separator);
        let records = builder.from_reader(&self.content[..]).into_byte_records();
        let is_blank = |row: &ByteRecord| row.is_empty() || (row.len() == 1 && row[0].trim_ascii().is_empty());
        let words = |row: ByteRecord| if self.separator == b' ' { without_empty_cells(&row) } else { row };
        records.map(move |row| row.map(words)).filter(move |row| !row.as_ref().is_ok_and(is_blank))
    }

    /// The line on which a row starts: the parser's own count stands before the blank lines that it skips.
    pub(super) fn line(&self, row: &ByteRecord) -> u64 {
        let offset = row.position().map_or(0, Position::byte);
        let offset = usize::try_from(offset).expect("the content is in memory").min(self.content.len());
        let rest = &self.content[offset..];
        let start = offset + rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        1 + self.content[..start].iter().filter(|&&byte| byte == b'\n').count() as u64
    }
}

/// A row of cells between any number of spaces.
fn without_empty_cells(row: &ByteRecord) -> ByteRecord {
    let mut words: ByteRecord = row.iter().filter(|cell| !cell.trim_ascii().is_empty()).collect();
    words.set_position(row.position().cloned());
    words
}

/// The first of comma, semicolon and tab that the first row has; else a space if the second row has one, which is no
/// header, or the first where it is the only one.
fn separator(content: &[u8]) -> u8 {
    let mut rows = content.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii).filter(|line| !line.is_empty());
    let first = rows.next().unwrap_or_default();
    let of_first = [b',', b';', b'\t'].into_iter().find(|separator| first.contains(separator));
    of_first.unwrap_or_else(|| if rows.next().unwrap_or(first).contains(&b' ') { b' ' } else { b',' })
}
