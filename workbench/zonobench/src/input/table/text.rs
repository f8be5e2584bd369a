//! The text of a table: which of its lines hold rows, and how a row falls into cells.

use std::borrow::Cow;
use std::ops::Range;

use csv::{ByteRecord, Position};

use super::separator;
use crate::input::names::{self, bodies};
use crate::input::number;

/// The marks with which a line of comment begins.
const COMMENTS: [&str; 3] = ["#", "%", "//"];

/// The names by which a comment above the rows is known as their header.
#[derive(Clone, Copy)]
pub(super) enum Naming<'a> {
    /// Those of coordinates, and those that were asked for.
    Points(&'a [&'a str]),
    /// Those of coordinates, of a centre and of generators.
    Vectors,
}

/// The text of a table, with spaces in place of the lines that hold no row: comments, and the first lines that are to
/// be skipped.
pub(super) struct Text<'a> {
    content: Cow<'a, [u8]>,
    skipped: u64,
    /// Lines of comment, by what they begin with.
    comments: [u64; COMMENTS.len()],
    /// The first line of comment that speaks of a centre, and its text.
    comment_on_center: Option<(u64, String)>,
    /// A first line such as `sep=;`.
    directive: Option<String>,
    separator: u8,
}

impl<'a> Text<'a> {
    /// The text without its first lines. A comment above the rows is their header where it has names of this kind.
    pub(super) fn new(content: Cow<'a, [u8]>, skip: u64, naming: Naming) -> Self {
        let comments = [0; COMMENTS.len()];
        let mut text =
            Self { content, skipped: 0, comments, comment_on_center: None, directive: None, separator: b',' };
        let holds_rows = marks_rows(&text.content);
        let (mut stated, mut header) = (None, None);
        let (mut is_first, mut number) = (true, 0);
        let mut start = 0;
        while start < text.content.len() {
            let rest = &text.content[start..];
            let length = rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |end| end + 1);
            let line = rest[..length].trim_ascii();
            let begin = start + rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count().min(length);
            let comment = COMMENTS.iter().position(|mark| line.starts_with(mark.as_bytes()));
            let mut blank = 0;
            number += 1;
            if text.skipped < skip {
                text.skipped += 1;
                blank = line.len();
            } else if is_first && let Some(separator) = directive(line) {
                text.directive = Some(String::from_utf8_lossy(line).into_owned());
                stated = Some(separator);
                blank = line.len();
            } else if is_first
                && let Some(mark) =
                    comment.filter(|&mark| names_columns(&line[COMMENTS[mark].len()..], &rest[length..], naming))
            {
                blank = COMMENTS[mark].len();
                header = Some(begin + blank..begin + line.len());
            } else if comment == Some(0) && (holds_rows || begins_with_error(line)) {
            } else if let Some(mark) = comment {
                text.comments[mark] += 1;
                let words = String::from_utf8_lossy(line);
                if text.comment_on_center.is_none() && bodies::speaks_of_center(&words[COMMENTS[mark].len()..]) {
                    text.comment_on_center = Some((number, words.into_owned()));
                }
                blank = line.len();
            }
            is_first &= line.is_empty() || comment.is_some();
            if blank > 0 {
                text.content.to_mut()[begin..begin + blank].fill(b' ');
            }
            start += length;
        }
        text.separator = stated.unwrap_or_else(|| separator::of(&text.content));
        if let Some(header) = header {
            text.separate(header);
        }
        text
    }

    /// Separates the names of a comment as the cells of the rows are, where it separates them otherwise.
    fn separate(&mut self, header: Range<usize>) {
        let separator = self.separator;
        let is_between = |byte: u8| b",;\t| ".contains(&byte);
        let names = self.content[header.clone()].trim_ascii();
        let begin =
            header.start + (self.content[header.clone()].len() - self.content[header.clone()].trim_ascii_start().len());
        if names.contains(&separator) || !names.iter().any(|&byte| is_between(byte)) {
            return;
        }
        let range = begin..begin + names.len();
        let mut was_between = false;
        for byte in &mut self.content.to_mut()[range] {
            let is_mark = is_between(*byte);
            if is_mark {
                *byte = if was_between { b' ' } else { separator };
            }
            was_between = is_mark;
        }
    }

    /// The first line of comment that speaks of a centre, and its text.
    pub(super) fn comment_on_center(&self) -> Option<&(u64, String)> {
        self.comment_on_center.as_ref()
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

/// Whether a line of comment such as `//X,Y,Z,Intensity` or `# y x`, without its mark, names the columns of the numbers
/// behind it. In `#,x,y` the mark itself is the name of the first column, which counts the rows.
fn names_columns(line: &[u8], behind: &[u8], naming: Naming) -> bool {
    let cells = |line: &[u8]| -> Vec<String> {
        let words = line.split(|byte| b",; \t".contains(byte)).filter(|word| !word.is_empty());
        words.map(|word| String::from_utf8_lossy(word).into_owned()).collect()
    };
    let mut named = cells(line.trim_ascii());
    let is_known = match naming {
        Naming::Points(asked) => {
            let has = |asked: &&str| named.iter().any(|name| name.eq_ignore_ascii_case(asked));
            (!asked.is_empty() && asked.iter().all(has)) || names::are_coordinates(&named)
        }
        Naming::Vectors => names::are_coordinates(&named) || bodies::are_of_bodies(&named),
    };
    if !is_known {
        return false;
    }
    if line.first().is_some_and(|byte| b",;\t".contains(byte)) {
        named.insert(0, "#".to_owned());
    }
    let mut rows = behind.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii).filter(|line| !line.is_empty());
    let is_comment = |line: &&[u8]| COMMENTS.iter().any(|mark| line.starts_with(mark.as_bytes()));
    let is_number = |cell: &String| number::is_number(cell.as_bytes());
    let is_row = |row: &[String]| row.len() == named.len() && row.iter().any(is_number);
    // A count of points may stand between.
    let mut next = || rows.find(|line| !is_comment(line)).map(cells);
    let first = next();
    let first = if first.as_ref().is_some_and(|row| row.len() == 1) { next() } else { first };
    first.is_some_and(|row| is_row(&row))
}

/// Whether a line that begins with `#` is a row whose first cell is the error of a spreadsheet.
fn begins_with_error(line: &[u8]) -> bool {
    let end = line.iter().position(|byte| b",;|\t".contains(byte));
    end.is_some_and(|end| number::is_error(&line[..end]))
}

/// Whether the lines that begin with `#` are rows whose first cell is a name such as `#1` or `#ff0000`: each goes on
/// with two numbers or more, and the other rows, as far as there are any behind the first one, have text there, too.
fn marks_rows(content: &[u8]) -> bool {
    let lines = || content.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii).filter(|line| !line.is_empty());
    let is_marked = |line: &&[u8]| line.starts_with(b"#");
    let mut others = lines().filter(|line| !is_marked(line));
    let is_row = |line: &[u8]| {
        let cells: Vec<&[u8]> = line.split(|byte| b",;\t ".contains(byte)).filter(|cell| !cell.is_empty()).collect();
        let is_name = cells[0].get(1).is_some_and(u8::is_ascii_alphanumeric);
        is_name && cells.len() >= 3 && cells[1..].iter().all(|cell| number::is_number(cell))
    };
    let begins_with_number = |line: &[u8]| {
        let end = line.iter().position(|byte| b",;\t ".contains(byte)).unwrap_or(line.len());
        number::is_number(&line[..end])
    };
    let first_is_row = others.next().is_some_and(begins_with_number);
    lines().any(|line| is_marked(&line))
        && lines().filter(is_marked).all(is_row)
        && !first_is_row
        && !others.any(begins_with_number)
}
