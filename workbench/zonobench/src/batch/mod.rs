//! Questions and answers as lines of JSON: what `zonobench solve` does with one line.
//!
//! A question is `{"id": …, "kind": …, "input": {…}, "method": …}` (the method is optional). A kind is one row of [`KINDS`].
//! What a question is refused for is looked for in this order: a line that is too long or is not JSON; a number that is not
//! finite, anywhere in the input; the fields of the question; its kind; its method; the fields and values of the input.

mod dimension;
mod fields;
mod kinds;
mod place;
mod question;
mod refusal;

use serde_json::{Map, Value, json};

use crate::json::Line;

pub use dimension::MAX_DIMENSION;
pub use kinds::{KINDS, Kind};
pub use refusal::{Code, Refusal};

/// The longest line that is read, in bytes.
pub const MAX_LINE_BYTES: usize = 128 << 20;

/// The largest number of points, or of generators, in one question.
pub const MAX_VECTORS: usize = 2_000_000;

/// The answer to one line.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The answer as a JSON object.
    pub content: Value,
    /// Whether the question was refused.
    pub refused: bool,
}

/// Answers one line of questions.
pub fn answer(number: u64, line: &Line, seed: u64) -> Answer {
    let mut content = Map::new();
    let outcome = match line {
        Line::Content(text) => question::read(number, text),
        Line::TooLong => Err(question::Unread {
            refusal: Refusal::new(Code::TooLarge, format!("line {number} is longer than {MAX_LINE_BYTES} bytes")),
            id: None,
            kind: None,
        }),
    };
    let refusal = match outcome {
        Err(unread) => {
            content.insert("id".to_owned(), unread.id.into());
            content.insert("kind".to_owned(), unread.kind.into());
            Some(unread.refusal)
        }
        Ok(question) => {
            content.insert("id".to_owned(), question.id.clone().into());
            content.insert("kind".to_owned(), question.kind.clone().into());
            match question.solve(seed) {
                Ok(solution) => {
                    content.insert("method".to_owned(), solution.method.into());
                    content.insert("result".to_owned(), solution.result);
                    None
                }
                Err(refusal) => Some(refusal),
            }
        }
    };
    let refused = refusal.is_some();
    if let Some(refusal) = refusal {
        let mut error = json!({"code": refusal.code.name(), "message": refusal.message});
        if refusal.code == Code::BadJson {
            error["line"] = number.into();
        }
        content.insert("error".to_owned(), error);
    }
    Answer { content: Value::Object(content), refused }
}
