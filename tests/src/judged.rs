//! Asking a question and giving its answer to the verifier, and the judgement of both together.

use batch::json::{MAX_VALUES, Tree, read};
use batch::{Line, Verdict, answer_line, check};
use serde_json::Value;

/// The parts of answers about few generators that may be left unchecked: points and weights that differ by many orders
/// of magnitude leave a gap to the lower bound.
const OPEN: [&str; 3] = [
    "it may not be the least",
    "the precision is not reached, as the answer says",
    "than rounding the centre to doubles explains",
];

/// The question is answered and its answer verifies, or it is refused with a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judged {
    /// The verifier calls the answer right, or leaves open what may stay open.
    Verified,
    /// The question has no answer, and the refusal says why.
    Refused,
}

/// A question or an answer as the verifier reads it.
pub fn tree(value: &Value) -> Tree {
    read(value.to_string().as_bytes(), MAX_VALUES).expect("questions and answers are JSON")
}

/// The answer of the program to a question.
pub fn answered(question: &Value) -> Value {
    answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content
}

/// Asks, and gives the answer to the verifier.
///
/// # Errors
///
/// The verdict, the answer and the question, where the answer is called wrong or is left unchecked without a reason
/// that is known.
pub fn judge(question: &Value) -> Result<Judged, String> {
    let answer = answered(question);
    if answer.get("error").is_some() {
        return Ok(Judged::Refused);
    }
    match check(&tree(question), &tree(&answer)) {
        Verdict::Right(_) => Ok(Judged::Verified),
        Verdict::Unchecked(reason) if OPEN.iter().any(|open| reason.contains(open)) => Ok(Judged::Verified),
        verdict => Err(format!("{verdict:?}: {answer} to {question}")),
    }
}
