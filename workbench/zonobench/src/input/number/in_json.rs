//! The numbers of a JSON document that a double does not hold as they are spelled. The parser rounds them without a
//! word, so that they are looked for in the text.

use super::Losses;
use crate::input::error::Place;
use crate::input::names;

/// The losses of a document that begins on this line. Numbers under `properties`, where GeoJSON has what is no
/// position, and those of fields that number or weigh the rows are not looked at.
pub(in crate::input) fn losses(text: &[u8], line: u64) -> Losses {
    let mut scan = Scan { text, index: 0, line, line_begins: 0, depth: 0, passed_over_from: None, key: None };
    let mut losses = Losses::default();
    while let Some(&byte) = text.get(scan.index) {
        match byte {
            b'"' => scan.string(),
            b'-' | b'0'..=b'9' => scan.number(&mut losses),
            b'{' | b'[' => scan.open(),
            b'}' | b']' => scan.close(),
            b'\n' => scan.end_line(),
            _ => scan.pass(byte),
        }
    }
    losses
}

/// The place of a scan in a document.
struct Scan<'a> {
    text: &'a [u8],
    index: usize,
    line: u64,
    /// The first byte of the line.
    line_begins: usize,
    /// The number of lists and objects that are open.
    depth: usize,
    /// The depth of an object whose numbers are not looked at.
    passed_over_from: Option<usize>,
    /// The last string, which names the value behind it if a colon follows.
    key: Option<&'a [u8]>,
}

impl Scan<'_> {
    fn string(&mut self) {
        let begin = self.index + 1;
        let mut end = begin;
        while self.text.get(end).is_some_and(|&byte| byte != b'"') {
            // A quote behind a backslash ends no string.
            end += if self.text[end] == b'\\' { 2 } else { 1 };
        }
        let end = end.min(self.text.len());
        self.key = Some(&self.text[begin..end]);
        self.index = end + 1;
    }

    fn number(&mut self, losses: &mut Losses) {
        let rest = &self.text[self.index..];
        let is_of_number = |byte: &u8| byte.is_ascii_digit() || b"+-.eE".contains(byte);
        let word = &rest[..rest.iter().position(|byte| !is_of_number(byte)).unwrap_or(rest.len())];
        let is_label = self.key.take().is_some_and(|key| names::is_label(&String::from_utf8_lossy(key)));
        if self.passed_over_from.is_none()
            && !is_label
            && let Some(number) = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok())
        {
            let column = (self.index - self.line_begins) as u64 + 1;
            losses.note(word, number, || Place::Cell { line: self.line, column });
        }
        self.index += word.len();
    }

    fn open(&mut self) {
        self.depth += 1;
        if self.key.take() == Some(b"properties") {
            self.passed_over_from.get_or_insert(self.depth);
        }
        self.index += 1;
    }

    fn close(&mut self) {
        if self.passed_over_from == Some(self.depth) {
            self.passed_over_from = None;
        }
        self.depth = self.depth.saturating_sub(1);
        self.index += 1;
    }

    fn end_line(&mut self) {
        self.index += 1;
        (self.line, self.line_begins) = (self.line + 1, self.index);
    }

    fn pass(&mut self, byte: u8) {
        if byte == b',' {
            self.key = None;
        }
        self.index += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_the_parser_rounds_are_told_with_line_and_column() {
        let told = |text: &str| losses(text.as_bytes(), 1).in_words();
        let rounded = "1 whole number has more digits than a double holds and is rounded";
        assert_eq!(
            told("[[1,2],\n [9007199254740993,0]]"),
            Some(format!("{rounded} (9007199254740993, line 2, column 3)"))
        );
        assert!(told(r#"{"x":[1e-400],"y":[1]}"#).expect("an underflow").contains("is read as 0 (1e-400, line 1"));
        assert!(told(r#"{"a\"":9007199254740993}"#).is_some());
        for lossless in [
            r#"[["9007199254740993",1]]"#,
            r#"[{"id":9007199254740993,"x":1,"y":2}]"#,
            r#"{"type":"Feature","properties":{"a":{"n":[1e-999]},"b":9007199254740993},"geometry":null}"#,
            "[-Infinity, NaN, 0.0, 1e-300]",
            "\"\\",
        ] {
            assert_eq!(told(lossless), None, "{lossless}");
        }
        assert!(told(r#"{"properties":{"n":1},"coordinates":[9007199254740993]}"#).is_some());
        assert!(told(r#"["id",9007199254740993]"#).is_some(), "a string in a list names nothing");
    }
}
