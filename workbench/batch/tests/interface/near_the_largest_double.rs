//! Figures near the largest double: they are infinite only where the exact ones are.

use batch::{Verdict, answer, verify};
use serde_json::{Value, json};

fn right(question: &Value) -> Value {
    let line = question.to_string();
    let answer = answer(&line);
    assert!(matches!(verify(&line, &answer), Verdict::Right(_)), "{question} {answer}");
    serde_json::from_str::<Value>(&answer).expect("an answer is JSON")["result"].clone()
}

#[test]
fn a_nearest_point_at_the_largest_double_is_finite() {
    let vector = [-f64::MAX, 8.988465674311579e307, 1.0];
    let found = right(&json!({"id": "t", "kind": "distance", "input": {
        "a": {"center": [2, -2, -2], "generators": [[1, 0, 0], vector]},
        "b": {"center": [0, -1e12, 0], "generators": [[1, 0, 0], vector]}}}));
    assert_eq!(found["nearest"]["b"][0], json!(f64::MAX), "{found}");
    let segment = [[-f64::MAX, 2.2e-16]];
    let found = right(&json!({"id": "t", "kind": "distance", "input": {
        "a": {"center": [0, 0], "generators": segment},
        "b": {"center": [6.9e307, -8.5e-17], "generators": segment}}}));
    assert_eq!(found["nearest"]["b"][0], json!(f64::MAX), "{found}");
}

#[test]
fn support_takes_more_coordinates_than_the_geometry_of_bodies() {
    let generators: Vec<Vec<f64>> =
        (0..20).map(|row| (0..10).map(|column| if row == column { 1.0 } else { 0.1 }).collect()).collect();
    let input =
        |dimension: usize| json!({"direction": vec![1; dimension], "center": vec![0; 10], "generators": generators});
    let found = right(&json!({"id": "t", "kind": "support", "input": input(10)}));
    // exactly 522417556774977555/18014398509481984
    assert_eq!(found["value"], json!(29.0));
    let refused = answer(&json!({"id": "t", "kind": "support", "input": input(9)}).to_string());
    assert!(refused.contains("dimension_mismatch") && refused.contains("10 coordinates, not 9"), "{refused}");
}
