//! First contacts of moving bodies through `solve` and `verify`: random fast motions, and the cases of public reports.

use batch::json::{MAX_VALUES, Tree, read};
use batch::{Line, Verdict, answer_line, check};
use serde_json::{Value, json};
use tests::dice::Dice;
use zonotope::motion::{Motion, MotionPiece};
use zonotope::zonotope::Zonotope;

/// The result of a question, and whether all of it was proved: nothing may be found wrong.
fn solved(input: &Value) -> (Value, bool) {
    let question = json!({"id": "q", "kind": "collide", "input": input});
    let mut answer = answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content;
    let tree = |value: &Value| -> Tree { read(value.to_string().as_bytes(), MAX_VALUES).expect("it is JSON") };
    let verdict = check(&tree(&question), &tree(&answer));
    assert!(!matches!(verdict, Verdict::Wrong(_)), "{verdict:?}: {question} {answer}");
    assert!(answer.get("error").is_none(), "{question} {answer}");
    (answer["result"].take(), verdict.is_right())
}

fn proved(input: &Value) -> Value {
    let (result, is_proved) = solved(input);
    assert!(is_proved, "{input} {result}");
    result
}

fn time(result: &Value) -> [f64; 2] {
    [0, 1].map(|i| result["time"][i].as_f64().expect("a time"))
}

/// Whether a contact is proved at a time that is known.
fn meets_at(result: &Value, expected: f64) {
    let [from, to] = time(result);
    assert_eq!(result["status"], "contact", "{result}");
    assert!(from - 1e-9 <= expected && expected <= to + 1e-9, "{from} {expected} {to}");
}

fn cuboid(center: [f64; 3], [x, y, z]: [f64; 3]) -> Value {
    json!({"center": center, "generators": [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]})
}

fn moved(translation: [f64; 3]) -> Value {
    let still = [1, 0, 0, 0];
    json!({"pieces": [{"until": 1, "from": still, "to": still, "axis_point": [0, 0, 0], "translation": translation}]})
}

fn turned(axis_point: [f64; 3], axis: [f64; 3], angle: f64, translation: [f64; 3]) -> Value {
    json!({"axis_point": axis_point, "axis": axis, "angle": angle, "translation": translation})
}

fn floats<const N: usize>(value: &Value) -> [f64; N] {
    let all: Vec<f64> = value.as_array().expect("a list").iter().map(|c| c.as_f64().expect("a number")).collect();
    all.try_into().expect("as many numbers")
}

fn body_of(value: &Value) -> Zonotope<3> {
    let generators = value["generators"].as_array().expect("a list").iter().map(floats).collect();
    Zonotope::new(floats(&value["center"]), generators).expect("finite")
}

fn motion_of(value: Option<&Value>) -> Motion {
    let Some(value) = value else { return Motion::rest() };
    let Some(pieces) = value["pieces"].as_array() else {
        let angle = value["angle"].as_f64().expect("a number");
        let [point, axis, translation] = ["axis_point", "axis", "translation"].map(|name| floats(&value[name]));
        return Motion::constant_rate(point, axis, angle, translation).expect("an axis");
    };
    let piece = |piece: &Value| MotionPiece {
        until: piece["until"].as_f64().expect("a number"),
        from: floats(&piece["from"]),
        to: floats(&piece["to"]),
        axis_point: floats(&piece["axis_point"]),
        translation: floats(&piece["translation"]),
    };
    Motion::from_pieces(&pieces.iter().map(piece).collect::<Vec<_>>()).expect("a motion")
}

/// The first of so many times at which the bodies, as doubles place them, meet.
fn sampled(input: &Value, steps: u32) -> Option<f64> {
    let bodies = ["a", "b"].map(|name| body_of(&input[name]));
    let motions = ["a", "b"].map(|name| motion_of(input["motion"].get(name)));
    (0..=steps).map(|step| f64::from(step) / f64::from(steps)).find(|&time| {
        let [p, q] = motions.each_ref().map(|motion| motion.pose_at(time).expect("finite"));
        bodies[0].at(&p).intersects(bodies[1].at(&q))
    })
}

fn random_vector(dice: &mut Dice, size: f64) -> [f64; 3] {
    [0, 1, 2].map(|_| size * dice.unit())
}

fn random_body(dice: &mut Dice, center: [f64; 3]) -> Value {
    let count = 1 + dice.below(8);
    let generators: Vec<[f64; 3]> = (0..count).map(|_| random_vector(dice, 1.4 / (count as f64).sqrt())).collect();
    json!({"center": center, "generators": generators})
}

fn random_pieces(dice: &mut Dice) -> Value {
    let count = 1 + dice.below(3);
    let pieces: Vec<Value> = (1..=count)
        .map(|number| {
            let mut quaternion = || [0, 1, 2, 3].map(|k| dice.below(9) as f64 - if k == 0 { 0.0 } else { 4.5 });
            let (from, to) = (quaternion(), quaternion());
            let is_opposite = from.iter().zip(to).map(|(p, q)| p * q).sum::<f64>() < 0.0;
            let to = if is_opposite { to.map(|c| -c) } else { to };
            json!({"until": number as f64 / count as f64, "from": from, "to": to,
                "axis_point": random_vector(dice, 2.0), "translation": random_vector(dice, 6.0)})
        })
        .collect();
    json!({ "pieces": pieces })
}

fn random_turn(dice: &mut Dice) -> Value {
    let [point, axis, translation] = [2.0, 1.0, 6.0].map(|size| random_vector(dice, size));
    turned(point, axis, 12.0 * dice.unit(), translation)
}

#[test]
fn random_fast_motions_are_proved_and_agree_with_sampling() {
    let mut dice = Dice::new(35);
    let mut counts = std::collections::BTreeMap::new();
    for case in 0..300 {
        let away = random_vector(&mut dice, 4.0);
        let (a, b) = (random_body(&mut dice, [0.0; 3]), random_body(&mut dice, away));
        let mut motion = json!({});
        for (name, is_there) in [("a", case % 5 != 0), ("b", case % 5 != 1)] {
            if is_there {
                motion[name] = if dice.one_in(2) { random_pieces(&mut dice) } else { random_turn(&mut dice) };
            }
        }
        let input = json!({"a": a, "b": b, "motion": motion});
        let (result, is_proved) = solved(&input);
        let status = result["status"].as_str().unwrap_or_default().to_owned();
        assert!(is_proved || status == "grazing", "{input} {result}");
        if let Some(met) = sampled(&input, 96) {
            assert!(status != "separate" && time(&result)[0] <= met, "{met}: {input} {result}");
        }
        *counts.entry(status).or_insert(0) += 1;
    }
    assert!(counts["separate"] > 40 && counts["contact"] > 40, "{counts:?}");
    assert!(counts.get("grazing").is_none_or(|count| *count <= 3), "{counts:?}");
}

/// Two boxes translated towards each other, whose bounds of the motion were added with their signs (FCL 555).
#[test]
fn boxes_that_are_translated_towards_each_other_meet() {
    let (a, b) = (cuboid([0.0, 0.0, 4.0], [1.0; 3]), cuboid([0.0, 0.0, -4.0], [1.0; 3]));
    let (down, up) = (moved([0.0, 0.0, -4.0]), moved([0.0, 0.0, 4.0]));
    meets_at(&proved(&json!({"a": a, "b": b, "motion": {"a": down, "b": up}})), 0.75);
    let past = moved([0.0, 9.0, -8.0]);
    assert_eq!(proved(&json!({"a": a, "b": b, "motion": {"a": past}}))["status"], "separate");
}

/// A box translated through another: conservative advancement found nothing (FCL 120).
#[test]
fn a_box_that_is_translated_through_another_meets_it() {
    let (a, b) = (cuboid([-10.0, 0.0, 0.0], [0.5, 1.0, 1.5]), cuboid([0.0, 0.25, 0.0], [1.0; 3]));
    meets_at(&proved(&json!({"a": a, "b": b, "motion": {"a": moved([20.0, 0.0, 0.0])}})), 0.425);
}

/// Thin slabs that a small body crosses at a flat angle: casts of shapes missed them (rapier.js 258).
#[test]
fn thin_slabs_that_are_crossed_at_a_flat_angle_are_met() {
    let cast = |half: [f64; 2], slab: [f64; 2], origin: [f64; 2], target: [f64; 2]| {
        let body = cuboid([origin[0], origin[1], 0.0], [0.5; 3]);
        let slab = cuboid([slab[0], slab[1], 0.0], [half[0], half[1], 1.0]);
        let path = moved([target[0] - origin[0], target[1] - origin[1], 0.0]);
        proved(&json!({"a": body, "b": slab, "motion": {"a": path}}))
    };
    // the lower side of the body comes down to the upper side of the slab
    let first = cast([244.5, 0.5], [884.5, 188.5], [380.0, 241.0], [1004.0, 137.0]);
    meets_at(&first, (241.0 - 0.5 - 189.0) / 104.0);
    let second = cast([335.0, 0.5], [408.0, 286.5], [894.0, 328.0], [385.0, 217.0]);
    meets_at(&second, (328.0 - 0.5 - 287.0) / 111.0);
}

/// A cuboid of 10 × 15 × 5, slightly turned, is let down on another: at the time of a cast it overlapped (rapier 434).
#[test]
fn a_turned_cuboid_is_free_until_the_time_that_is_told() {
    let lower = cuboid([0.0; 3], [5.0, 7.5, 2.5]);
    for (tangent, x) in [(0.02, 0.0), (0.1, 9.5), (-0.3, -11.0), (1e-6, 9.9)] {
        let square: f64 = 1.0 + tangent * tangent;
        let (cosine, sine) = ((1.0 - tangent * tangent) / square, 2.0 * tangent / square);
        let upper = json!({"center": [x, 40.0, 0.25], "generators":
            [[5.0 * cosine, 5.0 * sine, 0.0], [-7.5 * sine, 7.5 * cosine, 0.0], [0.0, 0.0, 2.5]]});
        let input = json!({"a": upper, "b": lower, "motion": {"a": moved([0.0, -60.0, 0.0])}});
        let result = proved(&input);
        assert_eq!(result["status"], "contact", "{tangent} {x}");
        // put down at the first of the two times it is free
        let mut put = upper.clone();
        put["center"][1] = json!(40.0 - 60.0 * time(&result)[0] + 1e-12);
        assert!(!body_of(&put).intersects(&body_of(&lower)), "{tangent} {x}");
    }
}

/// Cuboids of which one turns into the other, without that a nonlinear cast notices (parry 317).
#[test]
fn a_cuboid_that_turns_into_a_resting_one_meets_it() {
    let wall = cuboid([0.0, 0.0, 1.5], [0.05, 2.0, 1.5]);
    for angle in [0.4, 1.0, 3.0, -2.5, 6.0] {
        let arm = cuboid([1.5, 0.0, 0.4], [1.2, 0.1, 0.1]);
        let turn = turned([1.5, 2.0, 0.0], [0.0, 0.0, 1.0], angle, [-2.0, 0.0, 0.0]);
        let input = json!({"a": arm, "b": wall, "motion": {"a": turn}});
        let result = proved(&input);
        let met = sampled(&input, 4096);
        assert_eq!(met.is_some(), result["status"] == "contact", "{angle}: {met:?} {result}");
        if let Some(met) = met {
            assert!((met - time(&result)[1]).abs() <= 1.0 / 4096.0, "{angle}: {met} {result}");
        }
    }
}

/// A link that lies nearly flat and swings by almost 180° to lie flat on the other side: the hull of both end poses
/// does not hold what it sweeps (MoveIt 2889).
#[test]
fn a_swinging_link_meets_what_stands_above() {
    let link = cuboid([1.0, 0.0, 0.0], [1.0, 0.05, 0.05]);
    let post = cuboid([0.0, 0.0, 1.6], [0.1, 0.1, 0.1]);
    let swing = |from: f64, to: f64| {
        let (half, whole) = (to / 2.0 + from / 2.0, to - from);
        let start = turned([0.0; 3], [0.0, -1.0, 0.0], whole, [0.0; 3]);
        // the link begins at an angle: its vectors are turned before
        let (sine, cosine) = (libm::sin(from), libm::cos(from));
        let about = |v: [f64; 3]| [cosine * v[0] - sine * v[2], v[1], sine * v[0] + cosine * v[2]];
        let generators = [[1.0, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.05]].map(about);
        let link = json!({"center": about([1.0, 0.0, 0.0]), "generators": generators});
        (json!({"a": link, "b": post, "motion": {"a": start}}), half)
    };
    let (input, _) = swing(0.1, std::f64::consts::PI - 0.1);
    let result = proved(&input);
    assert_eq!(result["status"], "contact");
    assert!(time(&result)[1] < 0.5, "it comes from the side: {result}");
    let poses = [0.0, 1.0].map(|at| motion_of(input["motion"].get("a")).pose_at(at).expect("finite"));
    assert!(poses.iter().all(|pose| !body_of(&input["a"]).at(pose).intersects(&body_of(&post))), "both ends are free");
    let low = json!({"a": link, "b": cuboid([0.0, 0.0, 2.2], [0.1; 3]), "motion": {"a":
        turned([0.0; 3], [0.0, -1.0, 0.0], std::f64::consts::PI, [0.0; 3])}});
    assert_eq!(proved(&low)["status"], "separate", "it reaches 2");
}

/// A cube that turns in place beside a wall, by half a turn, by whole turns and by many.
#[test]
fn a_cube_that_turns_in_place_keeps_its_distance() {
    let cube = cuboid([0.0; 3], [1.0; 3]);
    for turns in [0.5, 1.0, 2.0, 25.0] {
        let turn = turned([0.0; 3], [0.0, 0.0, 1.0], std::f64::consts::TAU * turns, [0.0; 3]);
        let beside = |gap: f64| {
            let wall = cuboid([2f64.sqrt() + gap + 0.5, 0.0, 0.0], [0.5, 9.0, 9.0]);
            proved(&json!({"a": cube, "b": wall, "motion": {"a": turn}}))
        };
        assert_eq!(beside(1e-4)["status"], "separate", "{turns}");
        // a corner reaches the wall shortly before an eighth of a turn
        let met = beside(-1e-4);
        let corner = (std::f64::consts::FRAC_PI_4 - libm::acos(1.0 - 1e-4 / 2f64.sqrt())) / std::f64::consts::TAU;
        meets_at(&met, corner / turns);
    }
    let quarter = |until: f64| {
        json!({"until": until, "from": [1, 0, 0, 0], "to": [1, 0, 0, 1], "axis_point": [0, 0, 0],
            "translation": [0, 0, 0]})
    };
    let whole = json!({"pieces": [quarter(0.25), quarter(0.5), quarter(0.75), quarter(1.0)]});
    let wall = cuboid([2f64.sqrt() + 1e-9 + 0.5, 0.0, 0.0], [0.5, 9.0, 9.0]);
    assert_eq!(proved(&json!({"a": cube, "b": wall, "motion": {"a": whole}}))["status"], "separate");
}

/// Bodies that touch meet; where a turn is enclosed, touching is no proof of either.
#[test]
fn bodies_that_touch_at_the_start() {
    let (a, b) = (cuboid([0.0; 3], [1.0; 3]), cuboid([2.0, 0.5, 0.0], [1.0; 3]));
    let away = proved(&json!({"a": a, "b": b, "motion": {"b": moved([3.0, 0.0, 0.0])}}));
    assert_eq!((&away["status"], time(&away)), (&json!("contact"), [0.0, 0.0]));
    let (spun, _) = solved(&json!({"a": a, "b": b, "motion": {"b": turned([2.0, 0.5, 0.0], [1.0, 0.0, 0.0], 9.0,
        [0.0; 3])}}));
    assert_ne!(spun["status"], "separate");
    assert_eq!(time(&spun)[0], 0.0);
}

/// A needle that turns fast passes a grain between any two of a thousand samples.
#[test]
fn a_needle_that_turns_fast_misses_nothing() {
    let needle = cuboid([0.0; 3], [100.0, 1e-3, 1e-3]);
    let turn = turned([0.0; 3], [0.0, 0.0, 1.0], 3.0, [0.0; 3]);
    let grain = |radius: f64| cuboid([radius * libm::cos(1.0), radius * libm::sin(1.0), 0.0], [1e-3; 3]);
    let input = json!({"a": needle, "b": grain(90.0), "motion": {"a": turn}});
    assert_eq!(sampled(&input, 1000), None, "samples do not see it");
    let met = proved(&input);
    assert_eq!(met["status"], "contact");
    assert!((time(&met)[1] - 1.0 / 3.0).abs() < 1e-4, "{met}");
    let beyond = json!({"a": needle, "b": grain(100.01), "motion": {"a": turn}});
    assert_eq!(proved(&beyond)["status"], "separate");
    // a needle about an axis far away
    let far = turned([1e4, 0.0, 0.0], [0.0, 0.0, 1.0], -0.02, [0.0; 3]);
    let input = json!({"a": needle, "b": grain(90.0), "motion": {"a": far}});
    let result = proved(&input);
    assert_eq!(result["status"] == "contact", sampled(&input, 20_000).is_some(), "{result}");
}
