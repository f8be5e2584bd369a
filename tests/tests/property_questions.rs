//! Whatever the line, there is one answer to it: no panic, no refusal without a code, and what is accepted verifies.

use batch::json::{MAX_VALUES, Tree, read};
use batch::{Code, KINDS, Line, Verdict, answer_line, check};
use proptest::prelude::*;
use serde_json::{Value, json};

/// The answer to one line, which must be one in form.
fn answered(line: &[u8]) -> Value {
    let answer = answer_line(1, &Line::Content(line.to_vec()), 0);
    let content = answer.content;
    assert_eq!(answer.refused, content.get("error").is_some(), "{content}");
    assert_ne!(content.get("result").is_some(), content.get("error").is_some(), "{content}");
    if let Some(error) = content.get("error") {
        let code = error["code"].as_str().expect("a refusal has a code");
        assert!(Code::ALL.iter().any(|known| known.name() == code), "{code}");
        let message = error["message"].as_str().expect("a refusal has a message");
        assert!(!message.is_empty() && !message.contains('\n'), "{message:?}");
    }
    let written = content.to_string();
    assert!(!written.contains('\n'));
    content
}

fn tree(value: &Value) -> Tree {
    read(value.to_string().as_bytes(), MAX_VALUES).expect("an answer is JSON")
}

/// A double of any bits, the awkward ones often.
fn double() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => any::<u64>().prop_map(f64::from_bits),
        3 => (-3i32..4).prop_map(f64::from),
        2 => -1.0..1.0f64,
        1 => prop_oneof![
            Just(f64::MAX), Just(-f64::MAX), Just(f64::MIN_POSITIVE), Just(f64::from_bits(1)), Just(-0.0),
            Just(1e16), Just(1.0 + f64::EPSILON), Just(1e-300), Just(1e300),
        ],
    ]
}

/// A small multiple of the smallest double.
fn smallest() -> impl Strategy<Value = f64> {
    (-40i8..41).prop_map(|units| f64::from(units) * f64::from_bits(1))
}

/// As [`double`], but always a number.
fn finite() -> impl Strategy<Value = f64> {
    double().prop_map(|x| if x.is_finite() { x } else { 1.0 })
}

fn spelled(x: f64) -> Value {
    if x.is_nan() {
        "NaN".into()
    } else if x.is_infinite() {
        if x > 0.0 { "Infinity".into() } else { "-Infinity".into() }
    } else {
        x.into()
    }
}

fn vector(numbers: &mut impl Iterator<Item = f64>, dimension: usize) -> Value {
    numbers.take(dimension).map(spelled).collect()
}

fn vectors(numbers: &mut impl Iterator<Item = f64>, dimension: usize, count: usize) -> Value {
    (0..count).map(|_| vector(numbers, dimension)).collect()
}

/// The coordinates of what a kind asks about; the kinds that take any number of them are left out.
fn coordinates(kind: &str, dimension: usize) -> usize {
    match kind {
        "slope_selection" | "separator" | "walk" | "upper_hull" | "collide" | "sweep" | "mesh" | "mesh_level" => 3,
        "distance" | "hausdorff" | "member_batch" | "min_length_all" => dimension.min(3),
        "min_area" => 2,
        _ => dimension,
    }
}

/// Motions of two bodies: a rotation at constant rate and a rational part.
fn motions(n: &mut impl Iterator<Item = f64>) -> Value {
    let angle = vector(n, 1)[0].take();
    let [axis_point, axis, translation] = [(); 3].map(|()| vector(n, 3));
    let turn = json!({"axis_point": axis_point, "axis": axis, "angle": angle, "translation": translation});
    let [axis_point, translation] = [(); 2].map(|()| vector(n, 3));
    let part = json!({"until": 1, "from": [1, 0, 0, 0], "to": [1, 1, 0, 0], "axis_point": axis_point,
        "translation": translation});
    json!({"a": turn, "b": {"pieces": [part]}})
}

/// An input with the fields of a kind and the given numbers, in a dimension that the kind takes.
fn input(kind: &str, dimension: usize, count: usize, numbers: &[f64]) -> Value {
    const RULES: [&str; 8] = ["cluster", "lemma_5_5", "girard", "combastel", "pca", "scott", "adaptive", "best"];
    let mut numbers = numbers.iter().copied().cycle();
    let n = &mut numbers;
    let dimension = coordinates(kind, dimension);
    let body = |n: &mut _, count| {
        let center = vector(n, dimension);
        json!({"center": center, "generators": vectors(n, dimension, count)})
    };
    let fields = KINDS.iter().find(|known| known.name == kind).expect("the kind is one of the list").fields;
    let value = |name: &&'static str| {
        let value = match *name {
            "point" | "center" | "direction" | "p" | "q" => vector(n, dimension),
            "p0" => vector(n, 2),
            "points" if matches!(kind, "member_batch" | "min_length_dirs") => vectors(n, dimension, 3),
            "generators" | "directions" | "points" => vectors(n, dimension, count),
            "a" | "b" if matches!(kind, "mesh" | "mesh_level") => {
                let triangles: Vec<[usize; 3]> = (0..=count / 2).map(|at| [at % 3, (at + 1) % 4, 2]).collect();
                json!({"vertices": vectors(n, 3, 4), "triangles": triangles})
            }
            "a" => body(n, count / 2),
            "b" => body(n, count - count / 2),
            "weights" => n.take(count).map(|weight| spelled(weight.abs())).collect(),
            "epsilon" => 0.25.into(),
            "count" => dimension.into(),
            "rule" => RULES[count % RULES.len()].into(),
            "k" if kind == "slope_selection" => json!([1]),
            "k" | "level" => 1.into(),
            "facet" => json!([0, 1, -1]),
            "axis_point" | "axis" | "translation" => vector(n, 3),
            "angle" => vector(n, 1)[0].take(),
            "motion" => motions(n),
            other => panic!("no value is made for the field `{other}` of `{kind}`"),
        };
        ((*name).to_owned(), value)
    };
    Value::Object(fields.iter().map(value).collect())
}

/// The structures for many points give the answers that are given without them, and these verify.
fn structures_agree(count: usize, numbers: &[f64]) -> Result<(), TestCaseError> {
    let asked = |method: &str| {
        let mut question = question("member_batch", &input("member_batch", 3, count, numbers));
        question["method"] = method.into();
        let answer = answered(question.to_string().as_bytes());
        (check(&tree(&question), &tree(&answer)), answer)
    };
    let (_, plain) = asked("by_lad");
    for method in ["by_direction_tree", "by_cutting", "by_facets"] {
        let (verdict, answer) = asked(method);
        prop_assert!(verdict.is_right() || answer.get("error").is_some(), "{method}: {verdict:?}: {answer}");
        prop_assert_eq!(&answer["result"]["status"], &plain["result"]["status"], "{} {}", method, answer);
    }
    Ok(())
}

/// Every method for moving bodies has an answer that verifies, and none says that bodies meet which another one proves
/// to be separate.
fn methods_for_motion_agree(kinds: [usize; 2], count: usize, numbers: &[f64]) -> Result<(), TestCaseError> {
    let mut n = numbers.iter().rev().copied().cycle();
    let mut moving = input("collide", 3, count, numbers);
    moving["motion"] = json!({});
    for (name, kind) in ["a", "b"].into_iter().zip(kinds) {
        let stated = motions(&mut n);
        let still = json!([1, 0, 0, 0]);
        let motion = match kind {
            0 => continue,
            1 => stated["a"].clone(),
            2 => stated["b"].clone(),
            _ => json!({"pieces": [{"until": 1, "from": still, "to": still, "axis_point": [0, 0, 0],
                "translation": stated["a"]["translation"]}]}),
        };
        moving["motion"][name] = motion;
    }
    for (kind, input) in [("collide", moving), ("sweep", input("sweep", 3, count, numbers))] {
        let known = KINDS.iter().find(|known| known.name == kind).expect("a kind");
        let mut cases = Vec::new();
        for method in (known.methods)() {
            let mut question = question(kind, &input);
            question["method"] = method.into();
            let answer = answered(question.to_string().as_bytes());
            if let Verdict::Wrong(reason) = check(&tree(&question), &tree(&answer)) {
                prop_assert!(false, "{}: {} to {}", reason, answer, question);
            }
            cases.extend(answer["result"]["status"].as_str().map(|case| (method, case.to_owned())));
        }
        let has = |case: &str| cases.iter().any(|(_, known)| known == case);
        prop_assert!(!(has("separate") && has("contact")), "{:?}: {}", cases, input);
    }
    Ok(())
}

fn question(kind: &str, input: &Value) -> Value {
    json!({"id": "q", "kind": kind, "input": input})
}

/// Whether a number of the input is spelled as NaN or an infinity.
fn holds_text(value: &Value) -> bool {
    match value {
        Value::String(text) => ["NaN", "Infinity", "-Infinity"].contains(&text.as_str()),
        Value::Array(elements) => elements.iter().any(holds_text),
        Value::Object(fields) => fields.values().any(holds_text),
        _ => false,
    }
}

/// Every kind is asked; no answer is wrong, and few are left unchecked.
fn answers_verify(dimension: usize, count: usize, numbers: &[f64]) -> Result<(), TestCaseError> {
    // Weights and points that differ by many orders of magnitude leave a gap to the lower bound, and so do needles
    // between the bounds of a distance.
    let reasons = [
        "it may not be the least",
        "than rounding the centre to doubles explains",
        "the upper bound is not checked",
        "more than 1 % apart",
        "what encloses the placements",
        "take too much exact work",
    ];
    for kind in KINDS {
        let question = question(kind.name, &input(kind.name, dimension, count, numbers));
        let answer = answered(question.to_string().as_bytes());
        match check(&tree(&question), &tree(&answer)) {
            Verdict::Wrong(reason) => prop_assert!(false, "{}: {} to {}", reason, answer, question),
            Verdict::Unchecked(reason) => prop_assert!(
                answer.get("error").is_some() || reasons.iter().any(|known| reason.contains(known)),
                "{}: {} to {}",
                reason,
                answer,
                question
            ),
            Verdict::Right(_) => {}
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(tests::runner::cases(300)))]

    #[test]
    fn numbers_that_are_not_finite_come_first(
        numbers in prop::collection::vec(double(), 1..24), dimension in 1usize..5, count in 0usize..6
    ) {
        for kind in KINDS {
            let input = input(kind.name, dimension, count, &numbers);
            let bad = holds_text(&input);
            let question = question(kind.name, &input);
            let answer = answered(question.to_string().as_bytes());
            prop_assert_eq!(bad, answer["error"]["code"] == "non_finite", "{} to {}", answer, question);
        }
    }

    #[test]
    fn answers_to_any_numbers_verify(
        numbers in prop::collection::vec(finite(), 1..24), dimension in 1usize..5, count in 0usize..6
    ) {
        answers_verify(dimension, count, &numbers)?;
        structures_agree(count, &numbers)?;
    }

    #[test]
    fn answers_to_the_smallest_numbers_verify(
        numbers in prop::collection::vec(smallest(), 1..24), dimension in 1usize..5, count in 0usize..6
    ) {
        answers_verify(dimension, count, &numbers)?;
    }

    #[test]
    fn every_method_for_motion_has_an_answer_that_verifies(
        numbers in prop::collection::vec(finite(), 1..40), a in 0usize..4, b in 0usize..4, count in 0usize..6
    ) {
        methods_for_motion_agree([a, b], count, &numbers)?;
    }

    #[test]
    fn every_method_for_motion_takes_the_smallest_numbers(
        numbers in prop::collection::vec(smallest(), 1..40), a in 0usize..4, b in 0usize..4, count in 0usize..6
    ) {
        methods_for_motion_agree([a, b], count, &numbers)?;
    }

    #[test]
    fn answers_about_bodies_under_poses_verify(
        numbers in prop::collection::vec(double(), 1..40), kind in 0usize..7, d in 1usize..4, count in 0usize..6
    ) {
        let kind = ["member", "intersect", "gauge", "distance", "support", "member_batch", "combinatorics"][kind];
        let mut input = input(kind, d, count, &numbers);
        let mut numbers = numbers.iter().rev().copied().cycle();
        let mut pose = || json!({"matrix": vectors(&mut numbers, d, d), "translation": vector(&mut numbers, d)});
        match kind {
            "intersect" | "distance" => (input["a"]["pose"], input["b"]["pose"]) = (pose(), pose()),
            _ => input["pose"] = pose(),
        }
        let question = question(kind, &input);
        let answer = answered(question.to_string().as_bytes());
        prop_assert_eq!(holds_text(&input), answer["error"]["code"] == "non_finite", "{} to {}", answer, question);
        let verdict = check(&tree(&question), &tree(&answer));
        let has_proof = matches!(kind, "member" | "intersect" | "gauge");
        let is_proved = if has_proof { verdict.is_right() } else { !verdict.is_wrong() };
        prop_assert!(holds_text(&input) || is_proved, "{:?}: {} to {}", verdict, answer, question);
    }

    #[test]
    fn arbitrary_bytes_are_answered(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let answer = answered(&bytes);
        prop_assert!(answer.get("error").is_some());
    }

    #[test]
    fn damaged_questions_are_answered(
        numbers in prop::collection::vec(double(), 1..12),
        kind in 0..KINDS.len(),
        place in any::<prop::sample::Index>(),
        byte in any::<u8>(),
        cut in any::<bool>(),
    ) {
        let mut line = question(KINDS[kind].name, &input(KINDS[kind].name, 3, 3, &numbers)).to_string().into_bytes();
        let place = place.index(line.len());
        if cut {
            line.truncate(place);
        } else {
            line[place] = byte;
        }
        answered(&line);
    }

    #[test]
    fn fields_of_any_shape_are_answered(kind in 0..KINDS.len(), values in prop::collection::vec(shape(), 4)) {
        let kind = &KINDS[kind];
        let fields = kind.fields.iter().chain(kind.optional).zip(values.iter().cycle());
        let input: Value = Value::Object(fields.map(|(name, value)| ((*name).to_owned(), value.clone())).collect());
        let question = question(kind.name, &input);
        let answer = answered(question.to_string().as_bytes());
        if let Verdict::Wrong(reason) = check(&tree(&question), &tree(&answer)) {
            prop_assert!(false, "{}: {} to {}", reason, answer, question);
        }
    }
}

/// Poses of other shapes are refused with the place that is wrong.
#[test]
fn poses_of_other_shapes_are_refused_by_place() {
    let cube = || json!({"center": [0, 0, 0], "generators": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]});
    let identity = json!([[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    let error = |pose: Value, method: Option<&str>| {
        let mut body = cube();
        body["pose"] = pose;
        let mut question = question("intersect", &json!({"a": cube(), "b": body}));
        method.into_iter().for_each(|name| question["method"] = name.into());
        let answer = answered(question.to_string().as_bytes());
        [&answer["error"]["code"], &answer["error"]["message"]].map(|text| text.as_str().unwrap_or("").to_owned())
    };
    let of = |matrix: Value, translation: Value| error(json!({"matrix": matrix, "translation": translation}), None);
    let mismatch = |message: &str| ["dimension_mismatch".to_owned(), message.to_owned()];
    let bad = |message: &str| ["bad_input".to_owned(), message.to_owned()];
    assert_eq!(of(json!([[1, 0, 0], [0, 1, 0]]), json!([0, 0, 0])), mismatch("b, pose, matrix has 2 rows, not 3"));
    let ragged = json!([[1, 0, 0], [0, 1], [0, 0, 1]]);
    assert_eq!(of(ragged, json!([0, 0, 0])), mismatch("b, pose, matrix, row 2 has 2 coordinates, not 3"));
    assert_eq!(of(identity.clone(), json!([0, 0])), mismatch("b, pose, translation has 2 coordinates, not 3"));
    let entry = json!([[1, 0, 0], [0, null, 0], [0, 0, 1]]);
    assert_eq!(of(entry, json!([0, 0, 0])), bad("b, pose, matrix, row 2, entry 2 is null, not a number"));
    assert_eq!(of(json!(3), json!([0, 0, 0])), bad("`b, pose, matrix` is a number, not a list"));
    assert_eq!(error(json!([]), None), bad("`b, pose` is a list, not an object"));
    assert_eq!(error(json!({}), None), bad("`b, pose` has neither `matrix` nor `translation`"));
    let whole = json!({"matrix": identity, "translation": [0, 0, "NaN"]});
    let non_finite = ["non_finite", "b, pose, translation, coordinate 3 is NaN"].map(str::to_owned);
    assert_eq!(error(whole, None), non_finite);
    let whole = json!({"matrix": identity, "translation": [0, 0, 0]});
    let other = ["unknown_method", "`brute_force` does not take bodies under a pose; `by_lad` does"].map(str::to_owned);
    assert_eq!(error(whole.clone(), Some("brute_force")), other);
    let plane = json!({"point": [0, 0], "center": [0, 0], "generators": [], "pose": whole});
    let answer = answered(question("member", &plane).to_string().as_bytes());
    let message = "pose, matrix has 3 rows, not 2";
    assert_eq!([&answer["error"]["code"], &answer["error"]["message"]], ["dimension_mismatch", message]);
}

/// The area of this rectangle lies between the largest double and the next power of two, less than half a unit above:
/// rounded up it is infinite, rounded to the nearest it is not.
#[test]
fn an_area_just_above_the_largest_double_is_infinite_and_verifies() {
    let share = 1.25 / f64::from(1 << 27);
    let (width, height) = (2f64.powi(512) * (1.0 - share), 2f64.powi(512) * (1.0 + share));
    let points = json!([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]);
    let question = question("min_area", &json!({ "points": points }));
    let answer = answered(question.to_string().as_bytes());
    assert_eq!(answer["result"]["area"], "Infinity", "{answer}");
    assert!(matches!(check(&tree(&question), &tree(&answer)), Verdict::Right(_)), "{answer}");
}

/// A small JSON value of any shape.
fn shape() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        finite().prop_map(Value::from),
        (0u64..5).prop_map(Value::from),
        "[a-z]{0,4}".prop_map(Value::from),
    ];
    leaf.prop_recursive(3, 24, 4, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..4).prop_map(Value::from),
            (inner.clone(), prop::collection::vec(inner, 0..3))
                .prop_map(|(center, generators)| json!({"center": center, "generators": generators})),
        ]
    })
}
