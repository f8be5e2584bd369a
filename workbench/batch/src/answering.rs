//! The answer to a line: what the kind of its question says, or why the question is refused.

use serde_json::{Map, Value, json};

use zonotope::DEFAULT_SEED;

use crate::limits::MAX_LINE_BYTES;
use crate::question::{self, Question};
use crate::refusal::{Code, Refusal};

/// One line of a batch.
#[derive(Debug, PartialEq, Eq)]
pub enum Line {
    /// Its bytes, without the line's end.
    Content(Vec<u8>),
    /// A line above [`MAX_LINE_BYTES`], whose bytes were not kept.
    TooLong,
}

/// The answer to one line.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The answer as a JSON object.
    pub content: Value,
    /// Whether the question was refused.
    pub refused: bool,
}

/// The answer to a question, both as lines of JSON. Every text has an answer; one that is no question is refused.
pub fn answer(question: &str) -> String {
    answer_line(1, &line_of(question), DEFAULT_SEED).content.to_string()
}

/// The data of a picture of [`PICTURES`](crate::PICTURES), asked for and answered like a question.
pub fn picture(question: &str) -> String {
    let drawn = |question: &Question| question.draw().map(|sheet| vec![("result", sheet.into_json())]);
    respond(1, &line_of(question), drawn).content.to_string()
}

pub(super) fn line_of(question: &str) -> Line {
    let fits = question.len() <= MAX_LINE_BYTES;
    if fits { Line::Content(question.as_bytes().to_vec()) } else { Line::TooLong }
}

/// Answers the line with the given number of a batch. `seed` decides how long the methods that use random numbers
/// take; the optima do not depend on it.
pub fn answer_line(number: u64, line: &Line, seed: u64) -> Answer {
    respond(number, line, |question| {
        question.solve(seed).map(|solution| vec![("method", solution.method.into()), ("result", solution.result)])
    })
}

/// The answer to a line, with the fields that a question is answered with.
pub(super) fn respond(
    number: u64,
    line: &Line,
    fields: impl FnOnce(&Question) -> Result<Vec<(&'static str, Value)>, Refusal>,
) -> Answer {
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
            match fields(&question) {
                Ok(fields) => {
                    content.extend(fields.into_iter().map(|(name, value)| (name.to_owned(), value)));
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
