//! Questions about bodies that move.

mod meshes;
mod moving;
mod sweeps;

use batch::{Verdict, answer, verify};
use serde_json::{Value, json};

/// A question of `collide`, and its answer.
fn asked(input: &Value) -> (String, Value) {
    let question = json!({"id": "q", "kind": "collide", "input": input}).to_string();
    let answered = answer(&question);
    (question, serde_json::from_str(&answered).expect("an answer is JSON"))
}

/// The result of a question, which the verifier must find right.
fn right(input: &Value) -> Value {
    let (question, answer) = asked(input);
    let verdict = verify(&question, &answer.to_string());
    assert!(matches!(verdict, Verdict::Right(_)), "{question}\n{answer}\n{verdict:?}");
    answer["result"].clone()
}
