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

fn level(input: &Value, method: Option<&str>) -> (Value, Value) {
    let mut question = json!({"id": "q", "kind": "mesh_level", "input": input});
    if let Some(method) = method {
        question["method"] = method.into();
    }
    let answer = serde_json::from_str(&batch::answer(&question.to_string())).expect("answers are JSON");
    (question, answer)
}

/// A prism over a square: eight corners of a cube, and twelve triangles.
fn cube(size: f64) -> Value {
    let corner = |at: usize| [0, 1, 2].map(|k| if at >> k & 1 == 1 { size } else { -size });
    let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let triangles: Vec<[usize; 3]> = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    json!({"vertices": corners, "triangles": triangles})
}

#[test]
fn volumes_of_levels_contain_their_triangles_at_any_size() {
    let methods = batch::KINDS.iter().find(|kind| kind.name == "mesh_level").map(|kind| (kind.methods)());
    for method in methods.expect("a kind") {
        for size in [1.0, 0.1, 1e300, f64::MAX, 1e-300, 5e-324] {
            for depth in 0..4 {
                let (question, answer) = level(&json!({"a": cube(size), "level": depth}), Some(method));
                let nodes = answer["result"]["nodes"].as_array().unwrap_or_else(|| panic!("{answer}"));
                assert!(!nodes.is_empty() && nodes.len() <= 1 << depth, "{answer}");
                assert!(is_right(&question, &answer), "{method}, {size}: {answer}");
            }
        }
    }
    let (_, answer) = level(&json!({"a": cube(2.0), "level": 0}), None);
    let node = &answer["result"]["nodes"][0];
    assert_eq!(node["generators"], json!([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]), "{answer}");
}

#[test]
fn a_level_that_leaves_out_a_triangle_is_found_out() {
    let (question, answer) = level(&json!({"a": cube(0.1), "level": 2}), Some("obb"));
    let mut less = answer.clone();
    less["result"]["nodes"].as_array_mut().expect("nodes").pop();
    assert!(!is_right(&question, &less));
    let mut smaller = answer.clone();
    smaller["result"]["nodes"][0]["generators"].as_array_mut().expect("generators").pop();
    assert!(!is_right(&question, &smaller));
    let mut deeper = question;
    deeper["input"]["level"] = 1.into();
    assert!(!is_right(&deeper, &answer));
}

#[test]
fn what_has_no_level_is_refused_by_name() {
    let refused = |input: Value, method: Option<&str>| {
        let (_, answer) = level(&input, method);
        let text = |name: &str| answer["error"][name].as_str().unwrap_or_else(|| panic!("{answer}")).to_owned();
        [text("code"), text("message")]
    };
    let deep = refused(json!({"a": cube(1.0), "level": 21}), None);
    assert_eq!(deep, ["too_large", "level is 21, at most 20 is taken"]);
    let [code, message] = refused(json!({"a": cube(1.0), "level": 1}), Some("dop_18"));
    assert!(code == "unknown_method" && message.contains("obb"), "{message}");
    let posed = refused(json!({"a": moved([1.0, 0.0, 0.0]), "level": 0}), None);
    assert_eq!(posed, ["bad_input", "extra field `pose` in `a`"]);
}

#[test]
fn tests_are_counted_for_each_volume() {
    let drawn = |b: Value, volume: &str| -> Value {
        let question = json!({"id": "q", "kind": "mesh_tests", "input": {"a": cube(1.0), "b": b, "volume": volume}});
        serde_json::from_str(&batch::picture(&question.to_string())).expect("pictures are JSON")
    };
    let mut far = cube(1.0);
    far["pose"] = json!({"translation": [5, 0, 0]});
    let picture = drawn(far, "obb");
    assert_eq!(picture["result"]["node_tests"], 1, "{picture}");
    assert_eq!(picture["result"]["triangle_tests"], 0, "{picture}");
    let distance = &picture["result"]["distance"];
    assert!(distance[0].as_f64() <= Some(3.0) && distance[1].as_f64() >= Some(3.0), "{picture}");
    let picture = drawn(cube(1.5), "sphere");
    assert!(picture["result"]["witness"].is_null(), "{picture}");
    let picture = drawn(cube(1.0), "zonotope_6");
    assert!(picture["result"]["witness"].is_array() && picture["result"]["triangle_tests"].as_u64() > Some(0));
    let picture = drawn(cube(1.0), "zonotope6");
    let message = picture["error"]["message"].as_str().expect("a refusal");
    assert!(
        message.starts_with("there is no volume `zonotope6`; the volumes are aabb") && message.contains("`zonotope_6`")
    );
}
