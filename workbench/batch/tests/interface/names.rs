//! Bodies of questions under the names that files may give them.

use batch::{Verdict, answer, verify};
use serde_json::{Value, json};

fn answered(kind: &str, input: &Value) -> (Value, Verdict) {
    let question = json!({"id": "q", "kind": kind, "input": input}).to_string();
    let line = answer(&question);
    let verdict = verify(&question, &line);
    (serde_json::from_str(&line).expect("an answer is JSON"), verdict)
}

#[test]
fn a_body_has_one_answer_under_all_its_names() {
    let names = [
        json!({"center": [1, 2], "generators": [[1, 0], [0.5, 2]]}),
        json!({"centre": [1, 2], "generators": [[1, 0], [0.5, 2]]}),
        json!({"c": [1, 2], "G": [[1, 0.5], [0, 2]]}),
        json!({"x": [1, 2], "G": [[1, 0.5], [0, 2]]}),
        json!({"center": [1, 2], "G": [[1, 0.5], [0, 2]]}),
    ];
    let other = json!({"center": [9, 0], "generators": [[1, 1]]});
    for kind in ["intersect", "distance", "hausdorff"] {
        let results: Vec<Value> = names
            .iter()
            .map(|body| {
                let (answer, verdict) = answered(kind, &json!({"a": body, "b": other}));
                assert!(matches!(verdict, Verdict::Right(_)), "{kind} {body}: {verdict:?}");
                answer["result"].clone()
            })
            .collect();
        assert!(results.iter().all(|result| *result == results[0]), "{kind}: {results:?}");
    }
    for (kind, more) in [
        ("member", json!({"point": [1, 1]})),
        ("support", json!({"direction": [1, 1]})),
        ("member_batch", json!({"points": [[1, 1], [9, 9]]})),
        ("reduce", json!({"count": 2, "rule": "cluster"})),
    ] {
        let results: Vec<Value> = names
            .iter()
            .map(|body| {
                let mut input = body.clone();
                let more = more.as_object().expect("an object");
                input.as_object_mut().expect("an object").extend(more.clone());
                let (answer, verdict) = answered(kind, &input);
                assert!(matches!(verdict, Verdict::Right(_)), "{kind} {input}: {verdict:?}");
                answer["result"].clone()
            })
            .collect();
        assert!(results.iter().all(|result| *result == results[0]), "{kind}: {results:?}");
    }
    let (counted, verdict) = answered("combinatorics", &json!({"G": [[1, 0, 0], [0, 1, 1]]}));
    assert!(counted.get("result").is_some() && matches!(verdict, Verdict::Right(_)), "{counted} {verdict:?}");
}

#[test]
fn two_names_of_one_part_and_matrices_that_are_none_are_refused() {
    let message = |body: Value| {
        let input = json!({"a": body, "b": {"center": [0, 0], "generators": []}});
        let (answer, verdict) = answered("intersect", &input);
        assert!(!matches!(verdict, Verdict::Right(_)), "{input}: {verdict:?}");
        answer["error"]["message"].as_str().expect("a refusal").to_owned()
    };
    let list = json!([[1, 0]]);
    assert_eq!(message(json!({"center": [0, 0], "c": [1, 1], "generators": list})), "extra field `c` in `a`");
    assert_eq!(message(json!({"center": [0, 0], "G": [[1], [0]], "generators": list})), "extra field `G` in `a`");
    assert!(message(json!({"x": [0, 0], "generators": list})).starts_with("missing field `center` in `a`"));
    assert_eq!(message(json!({"c": [0, 0], "G": 7})), "`a, G` is a number, not a list");
    assert_eq!(message(json!({"c": [0, 0], "G": [1, 0]})), "`a, G, row 1` is a number, not a list");
    assert_eq!(message(json!({"c": [0, 0], "G": [[1, 2], [3]]})), "a, G, row 2 has 1 numbers, not 2");
    assert_eq!(message(json!({"c": [0, 0], "G": [[1]]})), "a, generator 1 has 1 coordinate, not 2");
}

/// The refusal of fields that stand beside `kind` says where they belong.
#[test]
fn fields_beside_the_kind_are_told_where_they_belong() {
    let question = json!({"id": "q", "kind": "min_area", "points": [[0, 0], [1, 2]]}).to_string();
    let line: Value = serde_json::from_str(&answer(&question)).expect("an answer is JSON");
    let told = "extra field `points` in the question; what a kind takes are fields of `input`";
    assert_eq!(line["error"], json!({"code": "bad_input", "message": told}));
}
