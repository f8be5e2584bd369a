//! Answers of `hausdorff`, `reduce` and `approx` where the distance is known, tiny, or below what rounding costs.

use batch::json::{MAX_VALUES, Tree, read};
use batch::{Line, Verdict, answer_line, check};
use serde_json::{Value, json};

/// The answer to a question, and what its check says.
fn asked(kind: &str, input: &Value) -> (Value, Verdict) {
    let question = json!({"id": "q", "kind": kind, "input": input});
    let answer = answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content;
    let tree = |value: &Value| -> Tree { read(value.to_string().as_bytes(), MAX_VALUES).expect("it is JSON") };
    let verdict = check(&tree(&question), &tree(&answer));
    assert!(!matches!(verdict, Verdict::Wrong(_)), "{verdict:?}: {answer}");
    (answer, verdict)
}

/// The value of a distance, between its bounds.
fn value(result: &Value) -> f64 {
    let number = |name: &str| result[name].as_f64().expect("the distance is finite");
    assert!(number("lower") <= number("value") && number("value") <= number("upper"), "{result}");
    number("value")
}

fn hausdorff(a: Value, b: Value) -> Value {
    asked("hausdorff", &json!({"a": a, "b": b})).0["result"].take()
}

fn at_origin(generators: Value) -> Value {
    let dimension = generators[0].as_array().map_or(0, Vec::len);
    json!({"center": vec![0.0; dimension], "generators": generators})
}

fn point(center: Value) -> Value {
    json!({"center": center, "generators": []})
}

#[test]
fn distances_of_points_and_intervals_are_exact() {
    let interval = json!({"center": [1.5], "generators": [[0.5]]});
    let result = hausdorff(point(json!([1.0])), interval);
    assert_eq!((value(&result), &result["a_subset_b"]), (1.0, &json!(true)));
    let result = hausdorff(point(json!([0, 0, 0])), point(json!([1, 2, 2])));
    assert_eq!((value(&result), &result["a_subset_b"]), (3.0, &json!(false)));
    let least = f64::from_bits(1);
    assert_eq!(value(&hausdorff(point(json!([0, 0])), point(json!([0, least])))), least);
    assert_eq!(value(&hausdorff(point(json!([-3.0])), point(json!([2.0])))), 5.0);
}

#[test]
fn distances_of_small_bodies_are_the_nearest_doubles() {
    let above = 1.0f64.next_up();
    let [unit, larger] = [1.0, above].map(|side| at_origin(json!([[side, 0, 0], [0, side, 0], [0, 0, side]])));
    assert_eq!(value(&hausdorff(unit, larger)), f64::EPSILON * 3f64.sqrt());
    let moment = at_origin(json!([[1, 1, 1], [1, 2, 4], [1, 3, 9]]));
    let result = hausdorff(moment.clone(), moment);
    assert_eq!((&result["lower"], &result["upper"]), (&json!(0.0), &json!(0.0)));
    // the end (1, 2, 0, 1, 0, 1) is √(|a|² − (a · b)² / |b|²) = √(7 − 36/7) from the line of the other segment
    let [a, b] = [json!([[1, 2, 0, 1, 0, 1]]), json!([[1, 1, 0, 2, 0, 1]])].map(at_origin);
    let result = hausdorff(a, b);
    assert_eq!(value(&result), (13.0f64 / 7.0).sqrt());
}

#[test]
fn nearly_equal_bodies_of_parallel_generators_are_an_ulp_apart() {
    let [below_one, below_two, below_three] = [1.0f64, 2.0, 3.0].map(f64::next_down);
    let center = [-1.3487579823427925e-93, -6.559998228098562e-254, -1.7174071909036352e-223];
    let doubled = |v: [f64; 3]| json!({"center": center, "generators": [v, v.map(|c| -c)]});
    let result = hausdorff(doubled([1.0, -3.0, -1.0]), doubled([below_one, -below_three, -below_one]));
    assert!((1e-17..2e-15).contains(&value(&result)), "{result}");
    let a = at_origin(json!([[-2, 2, -2], [-1, 1, 0], [1, -1, 0]]));
    let b =
        at_origin(json!(
            [[-below_two, below_two, -below_two], [-below_one, below_one, 0], [below_one, -below_one, 0],]
        ));
    assert_eq!(value(&hausdorff(a, b)), 6.0 * (1.0 - below_one));
}

#[test]
fn approximations_are_within_epsilon_however_small_the_numbers_are() {
    let unit = 8.095e-320;
    let of = |k: [f64; 4]| k.map(|c| c * unit);
    let (long, short) = ([-3.0, -3.0, 6.0, 3.0], [1.0, 1.0, -2.0, -1.0]);
    let generators = [long, short, [0.0; 4], short.map(|c| -c), long, short].map(of);
    for (input, what) in [
        (json!({"generators": generators, "epsilon": 1e-6}), "denormals"),
        (json!({"generators": [[1], [1], [1], [1]], "epsilon": 5e-324}), "an epsilon below rounding"),
        (json!({"generators": [[0.1, 0.3], [0.1, 0.3], [0.3, 0.9]], "epsilon": 1e-9}), "parallel generators"),
    ] {
        let (answer, verdict) = asked("approx", &input);
        assert!(verdict.is_right(), "{what}: {verdict:?}: {answer}");
    }
}

#[test]
fn distances_of_reductions_of_flat_and_parallel_bodies_are_found() {
    let parallel = json!([
        [3, -9, -3],
        [-4, 12, 4],
        [8, 8, -8],
        [1, -3, -1],
        [3, -9, -3],
        [4, 4, -4],
        [2, -6, -2],
        [2, -6, -2],
        [8, 8, -8],
        [-4, 12, 4],
        [-1, 3, 1],
    ]);
    let (answer, _) = asked("approx", &json!({"generators": parallel, "epsilon": 1e-6}));
    assert!(answer["result"]["hausdorff"]["upper"].as_f64().is_some_and(|upper| upper < 1e-4), "{answer}");
    let flat = [
        [6.0, 6.0, 0.0, -9.0, 6.0, 9.0],
        [7.0, 7.0, -1.0f64.next_down(), -8.0, 7.0, 8.0],
        [9.0, 9.0, -3.0f64.next_up(), -6.0, 9.0, 6.0],
        [-8.0, -8.0, 2.0, 7.0, -8.0, -7.0],
        [-2.0, -2.0, 0.0, 3.0, -2.0, -3.0],
        [2.0, 2.0, 0.0, -3.0, 2.0, 3.0],
        [3.0, 3.0, -3.0, 3.0, 3.0, -3.0],
    ];
    for rule in ["best", "scott", "cluster", "girard"] {
        let input = json!({"center": vec![0; 6], "generators": flat, "count": 6, "rule": rule});
        let (answer, _) = asked("reduce", &input);
        let bounds = &answer["result"]["hausdorff"];
        assert!(
            bounds["upper"].as_f64().zip(bounds["lower"].as_f64()).is_some_and(|(u, l)| l <= u),
            "{rule}: {answer}"
        );
    }
}
