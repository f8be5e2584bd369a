//! Moving meshes: answers by hand, statuses at sampled times, refusals by name, and changed answers that are found out.

use batch::{answer, verify};
use serde_json::{Value, json};

use super::{asked, right};

fn mesh(vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Value {
    json!({"vertices": vertices, "triangles": triangles})
}

/// A square of a size across the first axis, as two triangles.
fn square(x: f64, size: f64) -> Value {
    mesh(&[[x, 0.0, 0.0], [x, size, 0.0], [x, 0.0, size], [x, size, size]], &[[0, 1, 2], [1, 2, 3]])
}

fn piece(to: [f64; 4], axis_point: [f64; 3], translation: [f64; 3]) -> Value {
    json!({"pieces": [{"until": 1, "from": [1, 0, 0, 0], "to": to, "axis_point": axis_point,
                       "translation": translation}]})
}

fn moved(translation: [f64; 3]) -> Value {
    piece([1.0, 0.0, 0.0, 0.0], [0.0; 3], translation)
}

fn times(result: &Value) -> [f64; 2] {
    [0, 1].map(|i| result["time"][i].as_f64().expect("a time"))
}

/// A triangle that points at a square from a distance beside the first axis.
fn spike(x: f64, size: f64) -> Value {
    let corner = |by: [f64; 3]| [x + by[0] * size, by[1] * size, by[2] * size];
    mesh(&[corner([0.0, 0.25, 0.25]), corner([1.0, 0.25, 0.5]), corner([1.0, 0.5, 0.25])], &[[0, 1, 2]])
}

#[test]
fn a_spike_at_any_size() {
    for size in [1e-300, 1e-3, 1.0, 1e300] {
        let meet = |to: f64| {
            right(&json!({"a": square(0.0, size), "b": spike(4.0 * size, size), "resolution": 1e-9,
                          "motion": {"b": moved([to * size, 0.0, 0.0])}}))
        };
        let (over, met) = (meet(-3.5), meet(-8.0));
        assert!(over["status"] != "contact" && met["status"] != "separate", "{size}: {over} {met}");
        // nearer to the ends of the range doubts are left
        if (1e-200..1e200).contains(&size) {
            assert_eq!((&over["status"], &met["status"]), (&json!("separate"), &json!("contact")), "{size}");
            let [from, to] = times(&met);
            assert!(from <= 0.5 && 0.5 <= to + 1e-12 && to - from <= 1e-9, "{size}: {met}");
        }
        let start = right(&json!({"a": square(0.0, size), "b": square(0.0, size), "motion": {"a": moved([size; 3])}}));
        assert_eq!((&start["status"], times(&start)), (&json!("contact"), [0.0, 0.0]), "{size}");
    }
}

#[test]
fn poses_come_before_motions_and_flat_triangles_are_triangles() {
    let mut posed = square(0.0, 1.0);
    posed["pose"] = json!({"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "translation": [4, 0, 0]});
    // across the second axis from x = 3 to x = 4
    let met = right(&json!({"a": square(0.0, 1.0), "b": posed, "motion": {"b": moved([-4.0, 0.0, 0.0])}}));
    assert!(met["status"] == "contact" && times(&met)[0] <= 0.75 && 0.75 <= times(&met)[1], "{met}");
    let point = mesh(&[[4.0, 0.25, 0.25]], &[[0, 0, 0]]);
    let met = right(&json!({"a": square(0.0, 1.0), "b": point, "motion": {"b": moved([-8.0, 0.0, 0.0])}}));
    assert_eq!((&met["status"], &met["triangles"]), (&json!("contact"), &json!([0, 0])));
    let line = mesh(&[[4.0, 0.0, 2.0], [4.0, 1.0, 2.0], [4.0, 3.0, 2.0]], &[[0, 1, 2]]);
    let over = right(&json!({"a": square(0.0, 1.0), "b": line, "motion": {"b": moved([-8.0, 0.0, -0.5])}}));
    assert_eq!(over["status"], "separate");
}

#[test]
fn needles_in_doubt_are_told() {
    // both are upright, and meet when the needle points at the post: at the root of 2 less 1, which is no double
    let needle = mesh(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 0.0, 1e-9]], &[[0, 1, 2]]);
    let post = mesh(&[[2.0, 2.0, -1.0], [2.0, 2.0, 1.0], [2.0, 2.0, 1.0]], &[[0, 1, 2]]);
    let quarter = piece([1.0, 0.0, 0.0, 1.0], [0.0; 3], [0.0; 3]);
    let doubt = right(&json!({"a": needle, "b": post, "motion": {"a": quarter}}));
    let [from, to] = times(&doubt);
    let root = std::f64::consts::SQRT_2 - 1.0;
    assert!(doubt["status"] == "grazing" && from < root && root < to && to - from < 1e-9, "{doubt}");
}

/// Small whole numbers by a linear congruence.
struct Numbers(u64);

impl Numbers {
    /// From 0 to below a bound.
    fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32 % bound
    }

    /// Of at most a magnitude.
    fn whole(&mut self, most: u32) -> f64 {
        f64::from(self.below(2 * most + 1)) - f64::from(most)
    }
}

/// A motion of one piece in small whole numbers, which half a turn is above.
struct Random {
    to: [f64; 4],
    axis_point: [f64; 3],
    translation: [f64; 3],
}

impl Random {
    fn of(numbers: &mut Numbers) -> Self {
        let mut whole = |most: u32| numbers.whole(most);
        let to = [0, 1, 2, 3].map(|k| if k == 0 { 4.0 } else { whole(4) });
        Self { to, axis_point: [0; 3].map(|_| whole(2)), translation: [0; 3].map(|_| whole(8)) }
    }

    fn motion(&self) -> Value {
        piece(self.to, self.axis_point, self.translation)
    }

    /// The quaternion at a time.
    fn turn(&self, time: f64) -> [f64; 4] {
        [0, 1, 2, 3].map(|k| if k == 0 { 1.0 - time } else { 0.0 } + time * self.to[k])
    }
}

/// A few triangles in small whole numbers; some are flat.
fn random_mesh(numbers: &mut Numbers, away: f64) -> Vec<[f64; 3]> {
    let count = 3 * (1 + numbers.below(4));
    (0..count).map(|_| [away, 0.0, 0.0].map(|c| c + numbers.whole(2))).collect()
}

fn of_corners(corners: &[[f64; 3]], shift: [f64; 3]) -> Value {
    let corners: Vec<[f64; 3]> = corners.iter().map(|corner| [0, 1, 2].map(|k| corner[k] + shift[k])).collect();
    let triangles: Vec<[usize; 3]> = (0..corners.len() / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    mesh(&corners, &triangles)
}

/// Whether the meshes meet where motions put them at a time: asked about motions that keep the turns of that time.
fn meet_at(meshes: [&[[f64; 3]]; 2], motions: [&Random; 2], time: f64) -> bool {
    let [of_a, of_b] = motions;
    // the second mesh and its axis are shifted by what it travels more
    let shift = [0, 1, 2].map(|k| time * (of_b.translation[k] - of_a.translation[k]));
    let kept = |motion: &Random, shift: [f64; 3]| {
        let (turn, point) = (motion.turn(time), [0, 1, 2].map(|k| motion.axis_point[k] + shift[k]));
        json!({"pieces": [{"until": 1, "from": turn, "to": turn, "axis_point": point, "translation": [0, 0, 0]}]})
    };
    let found = right(&json!({"a": of_corners(meshes[0], [0.0; 3]), "b": of_corners(meshes[1], shift),
        "motion": {"a": kept(of_a, [0.0; 3]), "b": kept(of_b, shift)}}));
    let do_meet = found["status"] == "contact";
    assert!(if do_meet { times(&found) == [0.0, 0.0] } else { found["status"] == "separate" }, "{found}");
    do_meet
}

#[test]
fn statuses_are_those_of_samples() {
    let mut numbers = Numbers(37);
    let mut seen = [0; 2];
    for _ in 0..48 {
        let meshes = [random_mesh(&mut numbers, 0.0), random_mesh(&mut numbers, 4.0)];
        let motions = [Random::of(&mut numbers), Random::of(&mut numbers)];
        let found = right(&json!({"a": of_corners(&meshes[0], [0.0; 3]), "b": of_corners(&meshes[1], [0.0; 3]),
            "motion": {"a": motions[0].motion(), "b": motions[1].motion()}}));
        let end = if found["status"] == "separate" { 2.0 } else { times(&found)[0] };
        for sample in 0..=16 {
            let time = f64::from(sample) / 16.0;
            let meets = || meet_at(meshes.each_ref().map(Vec::as_slice), motions.each_ref(), time);
            assert!(time >= end || !meets(), "{time}: {found}");
        }
        match found["status"].as_str() {
            Some("contact") => seen[0] += 1,
            Some("separate") => seen[1] += 1,
            _ => {}
        }
    }
    assert!(seen.iter().all(|count| *count > 5), "{seen:?}");
}

#[test]
fn refusals_by_name() {
    let refused = |input: Value| {
        let (_, answer) = asked(&input);
        let text = |name: &str| answer["error"][name].as_str().map(str::to_owned).expect("a refusal");
        (text("code"), text("message"))
    };
    let still = moved([1.0, 0.0, 0.0]);
    let body = json!({"center": [0, 0, 0], "generators": [[1, 0, 0]]});
    let mixed = refused(json!({"a": square(0.0, 1.0), "b": body, "motion": {"a": still}}));
    let told = "`a` is a mesh and `b` is none: both are zonotopes, or both are meshes";
    assert_eq!(mixed, ("bad_input".to_owned(), told.to_owned()));
    let mixed = refused(json!({"a": body, "b": square(0.0, 1.0), "motion": {"a": still}}));
    assert_eq!(mixed.1, "`b` is a mesh and `a` is none: both are zonotopes, or both are meshes");
    let turned = json!({"axis_point": [0, 0, 0], "axis": [0, 0, 1], "angle": 1, "translation": [0, 0, 0]});
    let turned = refused(json!({"a": square(0.0, 1.0), "b": square(4.0, 1.0), "motion": {"b": turned}}));
    let told = "motion, b turns at constant rate: motions of meshes have `pieces`";
    assert_eq!(turned, ("bad_input".to_owned(), told.to_owned()));
    let mut posed = square(4.0, 1.0);
    posed["pose"] = json!({"matrix": [[0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]], "translation": [0.7, 0, 0]});
    let (code, message) = refused(json!({"a": square(0.0, 1.0), "b": posed, "motion": {"a": still}}));
    assert!(code == "bad_input" && message.starts_with("b, pose: no doubles equal the image"), "{message}");
    let empty = json!({"vertices": [], "triangles": []});
    assert_eq!(refused(json!({"a": square(0.0, 1.0), "b": empty, "motion": {"a": still}})).0, "empty");
    let question = json!({"id": "q", "kind": "collide", "method": "by_chord",
        "input": {"a": square(0.0, 1.0), "b": square(4.0, 1.0), "motion": {"a": still}}});
    let answer: Value = serde_json::from_str(&answer(&question.to_string())).expect("JSON");
    assert_eq!(answer["error"]["code"], "unknown_method", "{answer}");
}

/// All numbers of a value by their pointers.
fn numbers(value: &Value, pointer: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(pointer.to_owned()),
        Value::Array(elements) => {
            (0..).zip(elements).for_each(|(k, next): (usize, _)| numbers(next, &format!("{pointer}/{k}"), found));
        }
        Value::Object(fields) => fields.iter().for_each(|(k, next)| numbers(next, &format!("{pointer}/{k}"), found)),
        _ => {}
    }
}

#[test]
fn changed_numbers_are_found_out_but_for_other_proofs() {
    let input = json!({"a": square(0.0, 1.0), "b": spike(4.0, 1.0), "motion": {"b": moved([-8.0, 0.0, 0.0])}});
    let (question, right) = asked(&input);
    let mut places = Vec::new();
    numbers(&right["result"], "", &mut places);
    assert!(places.len() > 10);
    let is_right = |change: &dyn Fn(&mut Value)| {
        let mut answer = right.clone();
        change(&mut answer["result"]);
        assert_ne!(answer, right);
        verify(&question, &answer.to_string()).is_right()
    };
    for place in &places {
        let change = |by: f64| {
            is_right(&|result| {
                let number = result.pointer_mut(place).expect("a number");
                let changed = number.as_f64().expect("a number") + by;
                *number = if number.is_u64() { json!(changed as i64) } else { json!(changed) };
            })
        };
        let direction = place.contains("direction");
        // directions that are near each other separate alike, and a part may be free with one triangle more
        let is_other_proof = direction || place.ends_with("/a/1") || place.ends_with("/b/1");
        assert!(is_other_proof || !change(1.0), "{place}: {right}");
        assert!(direction || !change(-9.0), "{place}");
    }
    for (field, wrong) in [("status", json!("separate")), ("status", json!("grazing")), ("time", json!([0.0, 0.5]))] {
        let is_right = is_right(&|result| result[field] = wrong.clone());
        // of a doubt less is claimed
        assert!(!is_right || wrong == "grazing", "{field}: {wrong}");
    }
    assert!(!is_right(&|result| result["certificate"]["order"]["a"] = json!([0, 0])));
    assert!(!is_right(&|result| drop(result["certificate"]["intervals"].as_array_mut().map(Vec::pop))));
    assert!(!is_right(&|result| result["more"] = json!(1)));
}
