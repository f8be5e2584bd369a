//! Bodies under poses: in any dimension, with a matrix, a translation or both, they are answered as their images are.

use batch::{Verdict, answer, verify};
use serde_json::{Value, json};

/// The content of an answer, which the verifier must not find wrong.
fn asked(kind: &str, input: Value) -> Value {
    let question = json!({"id": "q", "kind": kind, "input": input}).to_string();
    let answered = answer(&question);
    let verdict = verify(&question, &answered);
    assert!(!matches!(verdict, Verdict::Wrong(_)), "{question}\n{answered}\n{verdict:?}");
    serde_json::from_str(&answered).expect("an answer is JSON")
}

/// The result of a question, which the verifier must find right.
fn right(kind: &str, input: Value) -> Value {
    let question = json!({"id": "q", "kind": kind, "input": input}).to_string();
    let answered = answer(&question);
    let verdict = verify(&question, &answered);
    assert!(matches!(verdict, Verdict::Right(_)), "{question}\n{answered}\n{verdict:?}");
    let answered: Value = serde_json::from_str(&answered).expect("an answer is JSON");
    answered["result"].clone()
}

/// Numbers that look random and are the same every time.
struct Numbers(u64);

impl Numbers {
    fn whole(&mut self, most: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as i64 % (2 * most + 1) - most
    }

    fn wholes(&mut self, dimension: usize, most: i64) -> Vec<f64> {
        (0..dimension).map(|_| self.whole(most) as f64).collect()
    }

    fn rows(&mut self, count: usize, dimension: usize, most: i64) -> Vec<Vec<f64>> {
        (0..count).map(|_| self.wholes(dimension, most)).collect()
    }
}

fn image(matrix: &[Vec<f64>], v: &[f64], translation: &[f64]) -> Vec<f64> {
    let along = |row: &Vec<f64>| row.iter().zip(v).map(|(m, x)| m * x).sum::<f64>();
    matrix.iter().zip(translation).map(|(row, moved)| along(row) + moved).collect()
}

/// Small whole numbers have images that doubles hold: the posed question and that about the image have one answer.
/// Sine and cosine of an angle, by the tangent of its half.
fn sine_and_cosine(tangent: f64) -> (f64, f64) {
    let square = tangent * tangent;
    (2.0 * tangent / (1.0 + square), (1.0 - square) / (1.0 + square))
}

#[test]
fn a_posed_body_is_answered_as_its_image_is() {
    let mut numbers = Numbers(7);
    for case in 0..120 {
        let dimension = 1 + case % 4;
        let (matrix, moved) = (numbers.rows(dimension, dimension, 3), numbers.wholes(dimension, 9));
        let zero = vec![0.0; dimension];
        let count = 1 + case / 4 % 5;
        let (center, generators) = (numbers.wholes(dimension, 5), numbers.rows(count, dimension, 4));
        let point = numbers.wholes(dimension, 20);
        let pose = json!({"matrix": matrix, "translation": moved});
        let placed_center = image(&matrix, &center, &moved);
        let placed: Vec<Vec<f64>> = generators.iter().map(|g| image(&matrix, g, &zero)).collect();
        let posed = json!({"center": center, "generators": generators, "pose": pose});
        let plain = json!({"center": placed_center, "generators": placed});
        let with = |body: &Value, name: &str, value: Value| {
            let mut body = body.clone();
            body[name] = value;
            body
        };
        let both = |kind: &str, [posed, plain]: [Value; 2], fields: &[&str]| {
            let [posed, plain] = [right(kind, posed), right(kind, plain)];
            for field in fields {
                assert_eq!(posed[field], plain[field], "{kind}: {field}");
            }
            posed
        };
        both("member", [&posed, &plain].map(|body| with(body, "point", json!(point))), &["member", "status"]);
        let points = numbers.rows(4, dimension, 15);
        let many = [&posed, &plain].map(|body| with(body, "points", json!(points)));
        let found = both("member_batch", many, &["status"]);
        assert!(found["status"].as_array().is_some_and(|all| all.len() == 4));
        let along = [&posed, &plain].map(|body| with(body, "direction", json!(point)));
        both("support", along, &["value", "point"]);
        let of_gauge = |p: &[f64], generators: &[Vec<f64>]| json!({"p": p, "q": point, "generators": generators});
        let gauges = [with(&of_gauge(&center, &generators), "pose", pose.clone()), of_gauge(&placed_center, &placed)];
        let gauges = gauges.map(|input| right("gauge", input)["gauge"].clone());
        match [gauges[0].as_f64(), gauges[1].as_f64()] {
            [Some(a), Some(b)] => assert!((a - b).abs() <= 1e-14 * b, "{a} {b}"),
            _ => assert_eq!(gauges[0], gauges[1]),
        }
        let faces = [json!({"generators": generators, "pose": pose}), json!({"generators": placed})];
        both("combinatorics", faces, &["affine_dim", "vertices", "edges", "facets", "facet_sizes", "measure"]);

        let few = |body: &Value| with(&with(body, "count", json!(dimension)), "rule", json!("girard"));
        let reduced = [&posed, &plain].map(|body| asked("reduce", few(body))["result"].clone());
        assert_eq!(reduced[0], reduced[1]);
        let pairs = [&posed, &plain].map(|body| asked("hausdorff", json!({"a": body, "b": plain}))["result"].clone());
        assert_eq!((&pairs[0], &pairs[0]["upper"]), (&pairs[1], &json!(0.0)));

        let other = json!({"center": point, "generators": numbers.rows(2, dimension, 4)});
        let pairs = [&posed, &plain].map(|body| json!({"a": body, "b": other}));
        both("intersect", pairs, &["intersects", "status"]);
        let pairs = [&posed, &plain].map(|body| json!({"a": other, "b": body}));
        both("intersect", pairs.clone(), &["intersects", "status"]);
        if dimension < 4 {
            let [posed, plain] = pairs.map(|input| asked("distance", input)["result"].clone());
            assert_eq!([&posed["status"], &posed["features"]], [&plain["status"], &plain["features"]]);
            let close = |a: &Value, b: &Value, off: f64| {
                let [a, b] = [a, b].map(|x| x.as_f64().unwrap_or(f64::NAN));
                assert!((a - b).abs() <= off * b.abs(), "{a} {b}");
            };
            close(&posed["distance"], &plain["distance"], 1e-14);
            if plain["status"] != "outside" {
                close(&posed["penetration"]["lower"], &plain["penetration"]["lower"], 0.02);
                close(&posed["penetration"]["upper"], &plain["penetration"]["upper"], 0.02);
            }
        }
    }
}

/// The images under a turn are no doubles: the verifier, which takes them exactly, finds every answer right.
#[test]
fn turned_bodies_of_the_line_and_the_plane_are_taken_exactly() {
    let mut numbers = Numbers(11);
    for case in 0..60 {
        let (sin, cos) = sine_and_cosine(0.1 * f64::from(case));
        let pose = json!({"matrix": [[cos, -sin], [sin, cos]], "translation": [0.1, -0.7]});
        let tenths = |vectors: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
            vectors.into_iter().map(|v| v.into_iter().map(|x| x / 10.0).collect()).collect()
        };
        let body = |numbers: &mut Numbers| json!({"center": [0.3, 0.1], "generators": tenths(numbers.rows(4, 2, 9))});
        let (mut a, b) = (body(&mut numbers), body(&mut numbers));
        a["pose"] = pose.clone();
        let pair = json!({"a": a, "b": b});
        right("intersect", pair.clone());
        asked("distance", pair);
        let posed = |name: &str, value: Value| {
            let mut input = a.clone();
            input[name] = value;
            input
        };
        right("member", posed("point", json!([0.5, 0.25])));
        right("member_batch", posed("points", json!([[0.5, 0.25], [0.3, 0.1], [9, 9]])));
        right("support", posed("direction", json!([0.5, 0.3])));
        right("combinatorics", json!({"generators": a["generators"], "pose": pose}));
        right("gauge", json!({"p": [0.3], "q": [7], "generators": [[0.1], [0.7]], "pose": {"matrix": [[cos]]}}));
    }
}

#[test]
fn a_translation_or_a_matrix_alone_is_a_pose() {
    let member = |point: [f64; 2], pose: Value| {
        let input = json!({"point": point, "center": [0, 0], "generators": [[1, 0], [0, 1]], "pose": pose});
        right("member", input)["status"].clone()
    };
    assert_eq!(member([11.0, 0.0], json!({"translation": [10, 0]})), "boundary");
    assert_eq!(member([0.0, 3.0], json!({"matrix": [[1, 0], [0, 4]]})), "inside");
    let body = json!({"center": [0, 0, 0], "generators": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]});
    let mut moved = body.clone();
    moved["pose"] = json!({"translation": [3, 0, 0]});
    let apart = right("distance", json!({"a": body, "b": moved}));
    assert_eq!((&apart["distance"], &apart["features"]["a"]), (&json!(1.0), &json!("facet")));
}

/// A matrix keeps which generators are parallel and which lie in a plane, whatever its products are rounded to.
#[test]
fn a_turned_body_has_the_faces_of_the_body() {
    let generators = json!([[1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [0, 0, 0.1]]);
    let plain = right("combinatorics", json!({"generators": generators}));
    let (sin, cos) = sine_and_cosine(0.3);
    let matrix = json!([[cos, -sin, 0], [0.6 * sin, 0.6 * cos, -0.8], [0.8 * sin, 0.8 * cos, 0.6]]);
    let turned = right("combinatorics", json!({"generators": generators, "pose": {"matrix": matrix}}));
    for field in ["affine_dim", "vertices", "edges", "facets", "facet_sizes"] {
        assert_eq!(turned[field], plain[field], "{field}");
    }
    assert_ne!(turned["measure"], plain["measure"], "the matrix is a rotation but for rounding");
}

#[test]
fn poses_at_the_ends_of_the_range() {
    for scale in [5e-324, 1e-300, 1e300, 8e307] {
        let pose = json!({"matrix": [[scale, 0], [0, 1]], "translation": [0, 0]});
        let body = json!({"center": [1, 0], "generators": [[1, 0], [0, 1]], "pose": pose});
        let other = json!({"center": [0, 2], "generators": [[1, 0], [0, 1]]});
        assert_eq!(right("intersect", json!({"a": body, "b": other}))["status"], "boundary", "{scale}");
        let mut many = body.clone();
        many["points"] = json!([[scale, 0], [0, 1], [0, 1.5]]);
        assert_eq!(right("member_batch", many)["status"], json!(["inside", "boundary", "outside"]), "{scale}");
    }
    let flat = json!({"center": [1, 2], "generators": [[1, 0], [0, 1]], "pose": {"matrix": [[0, 0], [0, 0]]}});
    let mut many = flat.clone();
    many["points"] = json!([[0, 0], [1, 0]]);
    assert_eq!(right("member_batch", many)["status"], json!(["boundary", "outside"]));
}

#[test]
fn a_pose_that_cannot_be_taken_is_named() {
    let refused = |kind: &str, input: Value| {
        let answered = asked(kind, input);
        answered["error"]["message"].as_str().expect("the question is refused").to_owned()
    };
    let square_body = json!({"center": [0, 0], "generators": [[1, 0], [0, 1]]});
    let square = json!({"center": [0, 0], "generators": [[1, 0], [0, 1]], "points": [[0, 0]]});
    let posed = |pose: Value| {
        let mut input = square.clone();
        input["pose"] = pose;
        refused("member_batch", input)
    };
    assert_eq!(posed(json!({})), "`pose` has neither `matrix` nor `translation`");
    assert_eq!(posed(json!({"matrix": [[1, 0]]})), "pose, matrix has 1 rows, not 2");
    assert_eq!(posed(json!({"matrix": [[1, 0], [0, 1, 2]]})), "pose, matrix, row 2 has 3 coordinates, not 2");
    assert_eq!(posed(json!({"translation": [1, 0, 0]})), "pose, translation has 3 coordinates, not 2");
    assert_eq!(
        posed(json!({"rotation": [1, 0]})),
        "extra field `rotation` in `pose`; a pose has `matrix`, `translation` or both"
    );
    assert_eq!(posed(json!(7)), "`pose` is a number, not an object");
    let body = json!({"center": [0, 0], "generators": [[0.3, 0]], "pose": {"matrix": [[0.1, 0], [0, 1]]}});
    let pair = refused("hausdorff", json!({"a": square_body, "b": body}));
    assert!(pair.starts_with("b, pose: no doubles equal the image"), "{pair}");
    let mut reduced = body.clone();
    (reduced["count"], reduced["rule"]) = (json!(2), json!("cluster"));
    assert!(refused("reduce", reduced).starts_with("pose: no doubles equal the image"));
    let tiles = json!({"generators": [[1, 0, 0]], "k": 0, "pose": {"translation": [1, 0, 0]}});
    assert_eq!(refused("separator", tiles), "extra field `pose` in the input");
    let four = json!({"center": [0, 0, 0, 0], "generators": [[0.1, 0, 0, 0]], "point": [0, 0, 0, 0],
        "pose": {"matrix": [[0.1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}});
    let of_four = refused("member", four);
    assert!(of_four.starts_with("pose: no doubles equal the image"), "{of_four}");
    assert!(of_four.contains("from four dimensions on other images are not taken; round the image"), "{of_four}");
    let flattened = json!({"generators": [[0.1, 0.3], [0.7, 0]], "pose": {"matrix": [[0.1, 0.1], [0, 0]]}});
    assert!(refused("combinatorics", flattened).starts_with("pose: no doubles equal the image"));
    let tree = json!({"id": "q", "kind": "member_batch", "method": "by_direction_tree", "input": {"center": [0, 0, 0],
        "generators": [[1, 0, 0]], "points": [], "pose": {"translation": [1, 0, 0]}}});
    assert!(answer(&tree.to_string()).contains("does not take a body under a pose"));
}
