//! Questions and answers as lines of JSON: the interface of the workbench without its program.
//!
//! A question is `{"id": …, "kind": …, "input": {…}, "method": …}` (the method is optional). A kind is one row of
//! [`KINDS`]. [`answer`] makes the answer of a line, [`verify`] checks an answer against its question exactly;
//! [`answer_line`] and [`check`] do the same for a caller who numbers the lines of a batch, chooses a seed, or has
//! read the JSON already.
//!
//! Reasons to refuse a question are looked for in this order: a line that is too long or is not JSON; a number that
//! is not finite, anywhere in the input; the fields of the question; its kind; its method; the fields and values of
//! the input.
//!
//! The crate reads no files and has no command line, so that a page or another program can ask, answer and verify.
//! Methods that need an engine for linear programs are there with the feature `linear-programming`.
//!
//! ```
//! let question =
//!     r#"{"id":"q","kind":"support","input":{"direction":[1,2],"center":[5,5],"generators":[[1,0],[0,1]]}}"#;
//! let answer = batch::answer(question);
//! assert!(answer.contains(r#""result":{"value":18.0,"point":[6.0,6.0]}"#));
//! assert!(matches!(batch::verify(question, &answer), batch::Verdict::Right(_)));
//! assert!(matches!(batch::verify(question, &answer.replace("18.0", "18.5")), batch::Verdict::Wrong(_)));
//! ```

mod dimension;
mod fields;
pub mod json;
mod kinds;
mod nearest;
mod place;
pub mod placement;
mod question;
mod refusal;
mod transcript;

use serde_json::{Map, Value, json};

pub use dimension::MAX_DIMENSION;
pub use fields::read_pose;
pub use kinds::{KINDS, Kind, min_area_result};
pub use nearest::{did_you_mean, nearest};
pub use refusal::{Code, Refusal};
pub use transcript::{Verdict, check, check_unread, guarded, verify};

/// The longest line that is read, in bytes.
pub const MAX_LINE_BYTES: usize = 128 << 20;

/// The largest number of points, or of generators, in one question.
pub const MAX_VECTORS: usize = 2_000_000;

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
    let fits = question.len() <= MAX_LINE_BYTES;
    let line = if fits { Line::Content(question.as_bytes().to_vec()) } else { Line::TooLong };
    answer_line(1, &line, 0).content.to_string()
}

/// Answers the line with the given number of a batch. `seed` decides how long the methods that use random numbers
/// take; the optima do not depend on it.
pub fn answer_line(number: u64, line: &Line, seed: u64) -> Answer {
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
