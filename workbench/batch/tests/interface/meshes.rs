//! Questions about meshes: answers by hand, with every volume, and false answers that are found out.

use serde_json::{Value, json};

/// A square in the plane x = 0, as two triangles.
fn square() -> Value {
    json!({"vertices": [[0, 0, 0], [0, 1, 0], [0, 0, 1], [0, 1, 1]], "triangles": [[0, 1, 2], [1, 2, 3]]})
}

fn moved(translation: [f64; 3]) -> Value {
    let mut mesh = square();
    mesh["pose"] = json!({"translation": translation});
    mesh
}

fn answered(input: &Value, method: Option<&str>) -> (Value, Value) {
    let mut question = json!({"id": "q", "kind": "mesh", "input": input});
    if let Some(method) = method {
        question["method"] = method.into();
    }
    let answer = serde_json::from_str(&batch::answer(&question.to_string())).expect("answers are JSON");
    (question, answer)
}

fn is_right(question: &Value, answer: &Value) -> bool {
    batch::verify(&question.to_string(), &answer.to_string()).is_right()
}

#[test]
fn every_volume_gives_the_same_answer() {
    let methods = batch::KINDS.iter().find(|kind| kind.name == "mesh").map(|kind| (kind.methods)());
    for method in methods.expect("a kind") {
        let (question, answer) =
            answered(&json!({"a": square(), "b": moved([0.0, 1.0, 0.0]), "pairs": true}), Some(method));
        assert_eq!(answer["result"]["pairs"], json!([[0, 0], [1, 0], [1, 1]]), "{method}: {answer}");
        assert!(is_right(&question, &answer), "{method}");
        let (question, answer) = answered(&json!({"a": square(), "b": moved([2.0, 0.5, 0.0])}), Some(method));
        let bounds = &answer["result"]["distance"];
        let [lower, upper] = ["lower", "upper"].map(|bound| bounds[bound].as_f64().expect("a number"));
        assert!(lower <= 2.0 && 2.0 <= upper && upper - lower <= 0.002, "{method}: {answer}");
        assert!(is_right(&question, &answer), "{method}");
    }
}

#[test]
fn touching_counts_to_the_last_place() {
    let (question, answer) = answered(&json!({"a": square(), "b": moved([0.0, 1.0, 1.0])}), None);
    assert_eq!(answer["result"], json!({"intersects": true, "witness": [1, 0]}));
    assert!(is_right(&question, &answer));
    let (question, mut answer) = answered(&json!({"a": square(), "b": moved([0.0, 1.0f64.next_up(), 1.0])}), None);
    assert_eq!(answer["result"]["intersects"], false, "{answer}");
    assert!(is_right(&question, &answer));
    answer["result"] = json!({"intersects": true, "witness": [1, 0]});
    assert!(!is_right(&question, &answer));
}

#[test]
fn a_mesh_within_another_one_does_not_meet_it() {
    let corners: Vec<[i32; 3]> = vec![[9, 9, 9], [9, -9, -9], [-9, 9, -9], [-9, -9, 9]];
    let around = json!({"vertices": corners, "triangles": [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]});
    let (question, answer) = answered(&json!({"a": around, "b": square()}), None);
    assert_eq!(answer["result"]["intersects"], false, "{answer}");
    assert!(is_right(&question, &answer));
}
