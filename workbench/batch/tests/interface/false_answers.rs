//! Answers that say something false, of every kind that was once called right: none is, and none stops the check.

use std::path::Path;

use batch::{Verdict, answer, guarded, verify};
use serde_json::{Value, json};

fn lines() -> Vec<Value> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/interface/false_answers.jsonl");
    let text = std::fs::read_to_string(file).expect("the answers are committed");
    text.lines().map(|line| serde_json::from_str(line).expect("a line is JSON")).collect()
}

#[test]
fn false_answers_are_not_called_right() {
    for line in lines() {
        let verdict = verify(&line["question"].to_string(), &line["answer"].to_string());
        let word = match &verdict {
            Verdict::Right(_) => "right",
            Verdict::Unchecked(_) => "unchecked",
            Verdict::Wrong(_) => "wrong",
        };
        assert_eq!(line["verdict"], word, "{}: {verdict:?}", line["question"]["id"]);
        if let Verdict::Unchecked(reason) | Verdict::Wrong(reason) = verdict {
            assert!(!reason.contains("internal error"), "{}: {reason}", line["question"]["id"]);
        }
    }
}

#[test]
fn fields_of_another_status_are_named() {
    let reasons: Vec<String> = lines()
        .iter()
        .filter_map(|line| match verify(&line["question"].to_string(), &line["answer"].to_string()) {
            Verdict::Unchecked(reason) => reason.split_once(" is not checked").map(|(field, _)| field.to_owned()),
            _ => None,
        })
        .collect();
    for name in ["penetration", "contact_normal", "distance_certificate"] {
        assert!(reasons.contains(&format!("the field `result, {name}`")), "{reasons:?}");
    }
}

#[test]
fn a_body_is_at_the_distance_0_from_itself() {
    let body = json!({"center": [0, 0, 0], "generators": [[1, 1, 1], [1, 2, 4], [1, 3, 9]]});
    let question = json!({"id": "q", "kind": "hausdorff", "input": {"a": body, "b": body}}).to_string();
    let verdict = verify(&question, &answer(&question));
    assert!(matches!(verdict, Verdict::Right(_)), "{verdict:?}");
}

#[test]
fn the_answers_of_approx_and_reduce_are_proved_from_above_as_well() {
    let generators = json!([[1, 0, 2], [0, 3, 1], [1, 1, 1], [2, -1, 0], [0.5, 0.25, -3], [1, -2, 1], [0.1, 0.7, 0.3]]);
    let approx = json!({"id": "q", "kind": "approx", "input": {"generators": generators, "epsilon": 0.1}});
    let reduce = |rule: &str| {
        let input = json!({"center": [0, 0, 0], "generators": generators, "count": 4, "rule": rule});
        json!({"id": "q", "kind": "reduce", "input": input})
    };
    for question in [approx, reduce("girard"), reduce("pca"), reduce("cluster"), reduce("best")] {
        let question = question.to_string();
        let verdict = verify(&question, &answer(&question));
        assert!(matches!(verdict, Verdict::Right(_)), "{question}: {verdict:?}");
    }
}

#[test]
fn a_check_that_panics_leaves_its_answer_unchecked_and_the_next_one_is_judged() {
    let mut verdicts = [Some("a broken invariant"), None, Some("another one")].map(|panics| {
        guarded(|| match panics {
            Some(reason) => panic!("{reason}"),
            None => Verdict::Right("judged".to_owned()),
        })
    });
    assert_eq!(verdicts[0], Verdict::Unchecked("internal error: a broken invariant".to_owned()));
    assert_eq!(verdicts[1], Verdict::Right("judged".to_owned()));
    verdicts[1] = guarded(|| std::panic::panic_any(7));
    assert_eq!(verdicts[1], Verdict::Unchecked("internal error: a check panicked".to_owned()));
}
