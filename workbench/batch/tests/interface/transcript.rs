//! The committed questions, asked and checked without the program: the answers are those that the program gives.

#![cfg(feature = "linear-programming")]

use std::path::Path;

use batch::{Verdict, answer, verify};

fn lines(name: &str) -> Vec<String> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/goldens").join(name);
    let text = std::fs::read_to_string(file).expect("the golden is committed");
    text.lines().map(str::to_owned).collect()
}

#[test]
fn every_committed_question_has_its_committed_answer() {
    let (questions, answers) = (lines("questions.jsonl"), lines("answers.jsonl"));
    assert!(!questions.is_empty() && questions.len() == answers.len());
    for (question, expected) in questions.iter().zip(&answers) {
        let mut found: serde_json::Value = serde_json::from_str(&answer(question)).expect("an answer is JSON");
        let expected: serde_json::Value = serde_json::from_str(expected).expect("an answer is JSON");
        // Whoever asks a single line asks line 1; the program counts those of its batch.
        if let Some(line) = expected["error"].get("line") {
            found["error"]["line"] = line.clone();
            found["error"]["message"] = expected["error"]["message"].clone();
        }
        assert_eq!(found, expected, "{question}");
        match verify(question, &answer(question)) {
            Verdict::Right(_) => {}
            Verdict::Unchecked(reason) => assert!(!reason.contains("not checked; the rest"), "{question}: {reason}"),
            Verdict::Wrong(reason) => panic!("{question}: {reason}"),
        }
    }
}
