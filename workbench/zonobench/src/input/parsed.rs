//! A JSON document of a file, and the numbers in it.

use std::path::Path;

use super::encoding;
use super::error::{InputError, Place, Problem};
use super::number as word;
use batch::json::{self, MAX_VALUES, NonFinite, ReadError, Tree};

/// Parses a document, with the parser's complaints placed in the file.
pub(super) fn parse(file: &Path, content: &[u8]) -> Result<Tree, InputError> {
    parsed(file, content, false)
}

/// Parses a document of points, with numbers beyond the range of doubles as texts, so that each is met in its place.
pub(super) fn parse_points(file: &Path, content: &[u8]) -> Result<Tree, InputError> {
    parsed(file, content, true)
}

fn parsed(file: &Path, content: &[u8], quotes_beyond: bool) -> Result<Tree, InputError> {
    let text = encoding::text(content).map_err(|problem| problem.at(file, Place::File))?;
    let read = json::read(&text, MAX_VALUES).or_else(|error| {
        let is_quotable = match &error {
            ReadError::Syntax { .. } => true,
            ReadError::OutOfRange { .. } => quotes_beyond,
            _ => false,
        };
        match is_quotable.then(|| with_quotes(&text, quotes_beyond)).flatten() {
            Some(quoted) => json::read(&quoted, MAX_VALUES),
            None => Err(error),
        }
    });
    read.map_err(|error| match error {
        ReadError::TooManyValues { limit } => Problem::TooMany { what: "values", limit }.at(file, Place::File),
        ReadError::OutOfRange { line, column } => {
            Problem::Shape(ReadError::OutOfRange { line, column }.to_string()).at(file, cell(line, column))
        }
        ReadError::RepeatedField { ref field, line, column } => {
            Problem::Shape(format!("the field `{field}` occurs twice in one object")).at(file, cell(line, column))
        }
        ReadError::Syntax { line, column, .. } if is_a_value_a_line(&text) => {
            let problem = "holds JSON lines, a value on each of them; write the values as one list, between [ and ] \
                           and with commas after all but the last";
            Problem::Shape(problem.to_owned()).at(file, cell(line, column))
        }
        ReadError::Syntax { line, column, message } => Problem::NotJson(message).at(file, cell(line, column)),
        other => Problem::NotJson(other.to_string()).at(file, Place::File),
    })
}

/// The text with quotes around NaN and the infinities, which Python writes without, and perhaps around numbers beyond
/// the range of doubles; `None` if there are none.
fn with_quotes(text: &[u8], quotes_beyond: bool) -> Option<Vec<u8>> {
    let mut quoted = Vec::with_capacity(text.len());
    let (mut is_found, mut is_in_string, mut index) = (false, false, 0);
    while let Some(&byte) = text.get(index) {
        let rest = &text[index..];
        let word = ["NaN", "Infinity", "-Infinity"].into_iter().find(|word| rest.starts_with(word.as_bytes()));
        if let Some(word) = word.filter(|_| !is_in_string) {
            quoted.extend([b"\"", word.as_bytes(), b"\""].concat());
            (is_found, index) = (true, index + word.len());
            continue;
        }
        if quotes_beyond && !is_in_string && (byte == b'-' || byte.is_ascii_digit()) {
            let length = rest.iter().take_while(|byte| b"+-.eE0123456789".contains(byte)).count();
            let number = &rest[..length];
            let is_beyond = matches!(word::number(number), Err(Problem::OutOfRange(_)));
            let mark: &[u8] = if is_beyond { b"\"" } else { b"" };
            quoted.extend([mark, number, mark].concat());
            (is_found, index) = (is_found || is_beyond, index + length);
            continue;
        }
        // A quote behind a backslash ends no string.
        let length = if is_in_string && byte == b'\\' { rest.len().min(2) } else { 1 };
        is_in_string ^= byte == b'"';
        quoted.extend(&rest[..length]);
        index += length;
    }
    is_found.then_some(quoted)
}

/// Whether each of the first two lines that are not blank is a list or an object by itself.
fn is_a_value_a_line(text: &[u8]) -> bool {
    let is_value = |line: &[u8]| {
        let read = json::read(line, MAX_VALUES).or_else(|error| match with_quotes(line, false) {
            Some(quoted) => json::read(&quoted, MAX_VALUES),
            None => Err(error),
        });
        matches!(read, Ok(Tree::List(_) | Tree::Object(_)))
    };
    let mut lines = text.split(|&byte| byte == b'\n').filter(|line| !line.trim_ascii().is_empty());
    [lines.next(), lines.next()].into_iter().all(|line| line.is_some_and(is_value))
}

fn cell(line: usize, column: usize) -> Place {
    Place::Cell { line: line as u64, column: column as u64 }
}

/// A finite number, perhaps written as a string; non-finite ones are named for what they are.
pub(super) fn number(value: &Tree) -> Result<f64, Problem> {
    match value {
        Tree::Number(number) => Ok(*number),
        Tree::Null => Err(Problem::NotFinite("null".to_owned())),
        Tree::Text(text) if NonFinite::spelled(text).is_some() => Err(Problem::NotFinite(text.clone())),
        Tree::Text(text) => word::number(text.as_bytes()),
        other => Err(Problem::Shape(format!("expected a number, found {}", other.describe()))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_lines_are_named_with_their_cure() {
        let complaint = |content: &str| parse(Path::new("p.json"), content.as_bytes()).expect_err(content).to_string();
        for content in ["{\"x\":1}\n{\"x\":2}\n", "[1,2]\r\n\r\n[3,4]", "{\"x\":NaN}\n{\"x\":2}\n{"] {
            let complaint = complaint(content);
            assert!(complaint.contains("holds JSON lines") && complaint.contains("between [ and ]"), "{complaint}");
        }
        for content in ["[1,2", "[[1,2]\n[3,4]]", "[1,2] x", "1\n2\n"] {
            let complaint = complaint(content);
            assert!(complaint.contains("is not JSON"), "{complaint}");
        }
    }
}
