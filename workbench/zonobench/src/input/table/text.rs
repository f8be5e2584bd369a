//! The text of a table: which of its lines hold rows, and how a row falls into cells.

use std::borrow::Cow;

use csv::{ByteRecord, Position};

use super::separator;

/// The marks with which a line of comment begins.
const COMMENTS: [&str; 3] = ["#", "%", "//"];

/// The text of a table, with spaces in place of the lines that hold no row: comments, and the first lines that are to
/// be skipped.
pub(super) struct Text<'a> {
    content: Cow<'a, [u8]>,
    skipped: u64,
    /// Lines of comment, by what they begin with.
    comments: [u64; COMMENTS.len()],
    /// A first line such as `sep=;`.
    directive: Option<String>,
    separator: u8,
}

impl<'a> Text<'a> {
    /// The text without its first lines.
    pub(super) fn new(content: Cow<'a, [u8]>, skip: u64) -> Self {
        let mut text = Self { content, skipped: 0, comments: [0; COMMENTS.len()], directive: None, separator: b',' };
        let mut stated = None;
        let mut is_first = true;
        let mut start = 0;
        while start < text.content.len() {
            let rest = &text.content[start..];
            let length = rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |end| end + 1);
            let line = rest[..length].trim_ascii();
            let begin = start + rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count().min(length);
            let comment = COMMENTS.iter().position(|mark| line.starts_with(mark.as_bytes()));
            let mut blank = 0;
            if text.skipped < skip {
                text.skipped += 1;
                blank = line.len();
            } else if is_first && let Some(separator) = directive(line) {
                text.directive = Some(String::from_utf8_lossy(line).into_owned());
                stated = Some(separator);
                blank = line.len();
            } else if is_first && names_coordinates(line) {
                blank = COMMENTS[2].len();
            } else if let Some(mark) = comment {
                text.comments[mark] += 1;
                blank = line.len();
            }
            is_first &= line.is_empty() || comment.is_some();
            if blank > 0 {
                text.content.to_mut()[begin..begin + blank].fill(b' ');
            }
            start += length;
        }
        text.separator = stated.unwrap_or_else(|| separator::of(&text.content));
        text
    }

    /// The separator of the cells; a space stands for any number of spaces and tabs.
    pub(super) fn separator(&self) -> u8 {
        self.separator
    }

    /// The lines that hold no row, in words.
    pub(super) fn left_out(&self) -> Vec<String> {
        let skipped = match self.skipped {
            0 => None,
            1 => Some("the first line".to_owned()),
            count => Some(format!("the first {count} lines")),
        };
        let directive = self.directive.as_ref().map(|line| format!("the first line, {line}"));
        let comments = COMMENTS.iter().zip(self.comments).filter_map(|(mark, count)| match count {
            0 => None,
            1 => Some(format!("1 line that begins with {mark}")),
            count => Some(format!("{count} lines that begin with {mark}")),
        });
        skipped.into_iter().chain(directive).chain(comments).collect()
    }

    /// The rows that are not blank.
    pub(super) fn rows(&self) -> impl Iterator<Item = csv::Result<ByteRecord>> {
        separator::records(&self.content, self.separator)
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

/// The separator that a line such as `sep=;` states, as spreadsheets write it.
fn directive(line: &[u8]) -> Option<u8> {
    match line.strip_prefix(b"sep=")? {
        [separator @ (b',' | b';' | b'\t' | b'|' | b' ')] => Some(*separator),
        _ => None,
    }
}

/// Whether a line such as `//X,Y,Z,Intensity` names the columns of a cloud of points.
fn names_coordinates(line: &[u8]) -> bool {
    let Some(line) = line.strip_prefix(COMMENTS[2].as_bytes()) else { return false };
    let mut words = line.split(|byte| b",; \t".contains(byte)).filter(|word| !word.is_empty());
    let mut is = |name: &[u8]| words.next().is_some_and(|word| word.eq_ignore_ascii_case(name));
    is(b"x") && is(b"y")
}
