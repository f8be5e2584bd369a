//! JSON as questions and answers are written: floats with correct rounding, non-finite floats as the strings `NaN`,
//! `Infinity` and `-Infinity`, no more values than a stated limit, no deeper nesting than the parser's own limit of
//! 128 levels.

mod number;
mod tree;

pub use number::{NonFinite, rows_to_json, to_json, vector_to_json};
pub use tree::{MAX_VALUES, ReadError, Tree, read};
