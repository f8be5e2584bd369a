//! Bodies in motion: statuses by hand, refusals by name, and errors planted in certificates, none of which is right.

use batch::{Verdict, verify};
use serde_json::{Value, json};

use super::{asked, right};

fn cube(center: [f64; 3]) -> Value {
    json!({"center": center, "generators": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})
}

fn bar(center: [f64; 3]) -> Value {
    json!({"center": center, "generators": [[4, 0, 0], [0, 0.125, 0], [0, 0, 0.125]]})
}

fn moved(translation: [f64; 3]) -> Value {
    let still = [1, 0, 0, 0];
    json!({"pieces": [{"until": 1, "from": still, "to": still, "axis_point": [0, 0, 0], "translation": translation}]})
}

fn turned(angle: f64, translation: [f64; 3]) -> Value {
    json!({"axis_point": [0, 0, 0], "axis": [0, 0, 3], "angle": angle, "translation": translation})
}

/// Half a turn about the third axis in two pieces of a quarter.
fn half_a_turn() -> Value {
    let piece = |until: f64| {
        json!({"until": until, "from": [1, 0, 0, 0], "to": [1, 0, 0, 1], "axis_point": [0, 0, 0],
               "translation": [0, 0, 0]})
    };
    json!({"pieces": [piece(0.5), piece(1.0)]})
}

#[test]
fn statuses_by_hand() {
    let passing = |x: f64| {
        right(&json!({"a": cube([0.0; 3]), "b": cube([x, -4.0, 0.0]),
        "motion": {"b": moved([0.0, 8.0, 0.0])}}))
    };
    assert_eq!(passing(2.5)["status"], "separate");
    let meeting = passing(1.5);
    assert_eq!(meeting["status"], "contact");
    let time = [0, 1].map(|i| meeting["time"][i].as_f64().expect("a time"));
    assert!(time[0] <= 0.25 && 0.25 <= time[1] && time[1] - time[0] <= 2f64.powi(-30), "{time:?}");
    let start = right(&json!({"a": cube([0.0; 3]), "b": cube([0.0; 3]), "motion": {"a": moved([9.0, 0.0, 0.0])}}));
    assert_eq!((&start["status"], &start["time"]), (&json!("contact"), &json!([0.0, 0.0])));
    let start =
        right(&json!({"a": cube([0.0; 3]), "b": cube([0.0; 3]), "motion": {"a": turned(1.0, [9.0, 0.0, 0.0])}}));
    assert_eq!((&start["status"], &start["time"]), (&json!("contact"), &json!([0.0, 0.0])));
    // the bar sweeps a half circle of the radius 4, and the cube stands 3 away
    for motion in [half_a_turn(), turned(std::f64::consts::PI, [0.0; 3]), turned(-7.0 * std::f64::consts::PI, [0.0; 3])]
    {
        let swept = |y: f64| right(&json!({"a": bar([0.0; 3]), "b": cube([0.0, y, 0.0]), "motion": {"a": motion}}));
        assert_eq!(swept(3.0)["status"], "contact", "{motion}");
        assert_eq!(swept(5.1)["status"], "separate", "{motion}");
    }
}

#[test]
fn a_resolution_is_kept() {
    for resolution in [0.25, 1e-3, 2f64.powi(-30), 1e-12, 2f64.powi(-50)] {
        let found = right(&json!({"a": cube([0.0; 3]), "b": cube([4.1, 0.3, 0.0]),
            "motion": {"b": moved([-5.0, 0.0, 0.1])}, "resolution": resolution}));
        let time = [0, 1].map(|i| found["time"][i].as_f64().expect("a time"));
        assert!(found["status"] == "contact" && time[1] - time[0] <= resolution, "{resolution}: {time:?}");
    }
}

#[test]
fn flat_bodies_and_points_are_answered() {
    let plate = |z: f64| json!({"center": [0, 0, z], "generators": [[1, 0, 0], [0, 1, 0]]});
    let point = |x: f64| json!({"center": [x, 0, 0], "generators": []});
    let fall = moved([0.0, 0.0, -2.0]);
    assert_eq!(right(&json!({"a": plate(0.0), "b": plate(3.0), "motion": {"b": fall}}))["status"], "separate");
    assert_eq!(right(&json!({"a": plate(0.0), "b": plate(0.0), "motion": {"b": fall}}))["time"], json!([0.0, 0.0]));
    assert_eq!(right(&json!({"a": plate(0.0), "b": plate(1.0), "motion": {"b": fall}}))["status"], "contact");
    assert_eq!(
        right(&json!({"a": point(0.0), "b": point(2.0), "motion": {"b": moved([-4.0, 0.0, 0.0])}}))["status"],
        "contact"
    );
    assert_eq!(right(&json!({"a": point(1.0), "b": point(1.0), "motion": {}}))["time"], json!([0.0, 0.0]));
}

#[test]
fn what_is_no_question_is_refused_by_name() {
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut input = json!({"a": cube([0.0; 3]), "b": cube([3.0, 0.0, 0.0]),
            "motion": {"a": turned(1.0, [1.0, 0.0, 0.0]), "b": half_a_turn()}});
        change(&mut input);
        let (_, answer) = asked(&input);
        let text = |name: &str| answer["error"][name].as_str().unwrap_or_default().to_owned();
        (text("code"), text("message"))
    };
    let told = |code: &str, message: &str| (code.to_owned(), message.to_owned());
    assert_eq!(refused(&|_| {}), told("", ""));
    assert_eq!(
        refused(&|input| input["motion"]["a"]["axis"] = json!([0, 0, 0])),
        told("zero_axis", "motion, a, axis is zero: a rotation needs an axis")
    );
    assert_eq!(
        refused(&|input| input["motion"]["a"]["angle"] = json!("NaN")),
        told("non_finite", "motion, a, angle is NaN")
    );
    assert_eq!(
        refused(&|input| input["motion"]["b"]["pieces"][1]["to"] = json!([0, 0, 0, 0])),
        told("zero_axis", "motion, b, piece 2: a quaternion is zero and turns about no axis")
    );
    let opposite = refused(&|input| input["motion"]["b"]["pieces"][0]["to"] = json!([-1, 0, 0, 1]));
    assert!(opposite.0 == "bad_angle" && opposite.1.starts_with("motion, b, piece 1: `from` and `to`"), "{opposite:?}");
    let times = refused(&|input| input["motion"]["b"]["pieces"][1]["until"] = json!(0.5));
    assert!(times.0 == "bad_input" && times.1.starts_with("motion, b, piece 2: the time 0.5"), "{times:?}");
    let last = refused(&|input| input["motion"]["b"]["pieces"][1]["until"] = json!(0.75));
    assert_eq!(last.0, "bad_input", "{last:?}");
    assert_eq!(refused(&|input| input["motion"]["b"]["pieces"] = json!([])).0, "bad_input");
    assert_eq!(
        refused(&|input| drop(input["motion"]["a"].as_object_mut().expect("an object").remove("angle"))),
        told("bad_input", "missing field `angle` in `motion, a`")
    );
    assert_eq!(refused(&|input| input["motion"]["c"] = json!({})), told("bad_input", "extra field `c` in `motion`"));
    assert_eq!(refused(&|input| input["motion"]["a"]["pieces"] = json!([])).0, "bad_input");
    assert_eq!(refused(&|input| input["a"]["center"] = json!([0, 0])).0, "dimension_mismatch");
    assert_eq!(refused(&|input| input["motion"]["a"]["axis"] = json!([0, 1])).0, "dimension_mismatch");
    assert_eq!(refused(&|input| input["motion"]["b"]["pieces"][0]["from"] = json!([1, 0, 0])).0, "dimension_mismatch");
    for resolution in [0.0, -1.0, 1.0, 1e-17] {
        assert_eq!(refused(&|input| input["resolution"] = json!(resolution)).0, "bad_epsilon", "{resolution}");
    }
    let piece = json!({"until": 1, "from": [1, 0, 0, 0], "to": [1, 0, 0, 1], "axis_point": [0, 0, 0],
        "translation": [0, 0, 0]});
    assert_eq!(refused(&|input| input["motion"]["b"]["pieces"] = json!(vec![piece.clone(); 1001])).0, "too_large");
}

/// Each change of an answer with a word for it.
fn planted(result: &Value) -> Vec<(String, Value)> {
    let mut all: Vec<(String, Value)> = Vec::new();
    let mut plant = |name: &str, change: &dyn Fn(&mut Value)| {
        let mut changed = result.clone();
        change(&mut changed);
        if changed != *result {
            all.push((name.to_owned(), changed));
        }
    };
    let intervals = |result: &mut Value| result["certificate"]["intervals"].as_array_mut().expect("a list").clone();
    let number = |value: &Value| value.as_f64().expect("a number");
    let opposite = |direction: &mut Value| {
        let negative = |v: &Value| v.as_array().expect("a vector").iter().map(|c| -number(c)).collect::<Value>();
        if direction[0].is_array() {
            direction[0] = negative(&direction[0]);
        } else {
            *direction = negative(direction);
        }
    };
    let count = result["certificate"]["intervals"].as_array().map_or(0, Vec::len);
    for i in 0..count {
        plant("a reversed direction", &|r| opposite(&mut r["certificate"]["intervals"][i]["direction"]));
        plant("no direction", &|r| r["certificate"]["intervals"][i]["direction"] = json!([0, 0, 0]));
        plant("a wider interval", &|r| {
            let interval = &mut r["certificate"]["intervals"][i];
            let (from, to) = (number(&interval["from"]), number(&interval["to"]));
            interval["to"] = json!(to + (to - from));
        });
        plant("an earlier interval", &|r| {
            let interval = &mut r["certificate"]["intervals"][i];
            interval["from"] = json!(number(&interval["from"]) - 1e-3);
        });
        plant("a gap between intervals", &|r| {
            let interval = &mut r["certificate"]["intervals"][i];
            interval["to"] = json!(number(&interval["to"]).next_down());
        });
        plant("a missing interval", &|r| {
            let mut left = intervals(r);
            left.remove(i);
            r["certificate"]["intervals"] = json!(left);
        });
        plant("an interval twice", &|r| {
            let mut more = intervals(r);
            more.insert(i, more[i].clone());
            r["certificate"]["intervals"] = json!(more);
        });
        plant("an unknown frame", &|r| r["certificate"]["intervals"][i]["frame"] = json!("c"));
        plant("one more field", &|r| r["certificate"]["intervals"][i]["gap"] = json!(1));
    }
    plant("intervals in the other order", &|r| {
        let mut reversed = intervals(r);
        reversed.reverse();
        r["certificate"]["intervals"] = json!(reversed);
    });
    for (status, name) in [("separate", "no contact"), ("contact", "a contact"), ("grazing", "a grazing")] {
        plant(name, &|r| r["status"] = json!(status));
    }
    plant("a field of another status", &|r| r["padding"] = json!(1));
    if result["status"] == "contact" {
        plant("no time", &|r| drop(r.as_object_mut().expect("an object").remove("time")));
        plant("a wider bracket", &|r| r["time"][0] = json!(number(&r["time"][0]) - 1e-3));
        plant("a later contact", &|r| r["time"][1] = json!(number(&r["time"][1]) + 1e-3));
        plant("an earlier contact", &|r| r["time"][1] = json!(number(&r["time"][0]) * 0.5));
        plant("times in the other order", &|r| {
            let time = r["time"].as_array().expect("two times").iter().rev().cloned().collect();
            r["time"] = time;
        });
        let basis: Vec<usize> = serde_json::from_value(result["certificate"]["basis"].clone()).expect("indices");
        for &index in &basis {
            plant("another coefficient of the basis", &|r| {
                let value = number(&r["certificate"]["coefficients"][index]);
                r["certificate"]["coefficients"][index] = json!(if value > 0.0 { value - 0.25 } else { value + 0.25 });
            });
            plant("no basis", &|r| r["certificate"]["basis"] = json!([]));
            plant("a basis of one generator", &|r| r["certificate"]["basis"] = json!([index, index, index]));
        }
        plant("a basis that does not exist", &|r| r["certificate"]["basis"][0] = json!(99));
        let coefficients = result["certificate"]["coefficients"].as_array().map_or(0, Vec::len);
        for index in 0..coefficients {
            plant("a coefficient above 1", &|r| r["certificate"]["coefficients"][index] = json!(1.5));
        }
        plant("one coefficient less", &|r| {
            drop(r["certificate"]["coefficients"].as_array_mut().expect("a list").pop());
        });
    }
    all
}

/// Questions of each status, with motions of pieces and at constant rate.
fn questions() -> Vec<Value> {
    let tilted = json!({"axis_point": [0.1, 0.2, 0], "axis": [1, 2, 3], "angle": 5.5, "translation": [0.5, 0, -0.25]});
    let motions = [half_a_turn(), turned(2.0, [0.25, 0.0, 0.0]), tilted];
    let mut all = Vec::new();
    for motion in &motions {
        for y in [2.2, 3.3, 5.6] {
            let (a, b) = (bar([0.25, 0.0, 0.0]), cube([0.3, y, 0.1]));
            all.push(json!({"a": a, "b": b, "motion": {"a": motion, "b": turned(1.0, [0.0, 0.25, 0.0])}}));
            all.push(json!({"a": b, "b": a, "motion": {"b": motion}}));
        }
    }
    all
}

#[test]
fn planted_errors_are_never_right() {
    let mut statuses = std::collections::BTreeMap::new();
    for input in questions() {
        let (question, answer) = asked(&input);
        let result = right(&input);
        *statuses.entry(result["status"].to_string()).or_insert(0) += 1;
        for (name, changed) in planted(&result) {
            let mut wrong = answer.clone();
            wrong["result"] = changed;
            let verdict = verify(&question, &wrong.to_string());
            assert!(!matches!(verdict, Verdict::Right(_)), "{name}: {question}\n{wrong}\n{verdict:?}");
        }
        // the answer to a question is none to that with the bodies, or with their motions, exchanged
        let mut exchanged = input.clone();
        (exchanged["a"], exchanged["b"]) = (input["b"].clone(), input["a"].clone());
        let mut others = vec![exchanged];
        // a direction may separate the bodies along the other one's motion, but they do not meet where they did
        let is_contact = result["status"] == "contact";
        if let (true, Some(of_a), Some(of_b)) = (is_contact, input["motion"].get("a"), input["motion"].get("b")) {
            let mut exchanged = input.clone();
            exchanged["motion"] = json!({"a": of_b, "b": of_a});
            others.push(exchanged);
        }
        for other in others {
            let question = json!({"id": "q", "kind": "collide", "input": other}).to_string();
            let verdict = verify(&question, &answer.to_string());
            assert!(!matches!(verdict, Verdict::Right(_)), "{question}\n{answer}\n{verdict:?}");
        }
    }
    assert!(statuses["\"separate\""] >= 3 && statuses["\"contact\""] >= 6, "{statuses:?}");
}

/// An angle of which doubles do not hold a turn proves nothing, and costs no answer.
#[test]
fn angles_of_any_size_are_answered() {
    for angle in [1e10, -3e15, 1.3e16, 1.41e16, 5e16, 1e100, -1.7e308] {
        for x in [0.5, 2.2, 9.0] {
            let input =
                json!({"a": cube([0.0; 3]), "b": cube([x, 0.0, 0.0]), "motion": {"a": turned(angle, [0.0; 3])}});
            let (question, answer) = asked(&input);
            let verdict = verify(&question, &answer.to_string());
            assert!(!matches!(verdict, Verdict::Wrong(_)), "{question}\n{answer}\n{verdict:?}");
            assert!(x > 3.0 || answer["result"]["status"] != "separate", "{question}\n{answer}");
        }
    }
}

/// A direction in the frame of a body that turns is none in another frame.
#[test]
fn a_wrong_frame_is_noticed() {
    let mut frames = 0;
    for input in questions() {
        let (question, answer) = asked(&input);
        let count = answer["result"]["certificate"]["intervals"].as_array().map_or(0, Vec::len);
        for i in 0..count {
            let interval = &answer["result"]["certificate"]["intervals"][i];
            let [from, to] = ["from", "to"].map(|name| interval[name].as_f64().expect("a time"));
            for frame in ["space", "a", "b", "edges"] {
                // a short interval near the start, where frames have not turned apart, may be proved by either
                if interval["frame"] == frame || from < 0.25 || to - from < 0.05 {
                    continue;
                }
                let mut wrong = answer.clone();
                wrong["result"]["certificate"]["intervals"][i]["frame"] = json!(frame);
                frames += usize::from(!matches!(verify(&question, &wrong.to_string()), Verdict::Right(_)));
            }
        }
    }
    assert!(frames >= 10, "{frames}");
}
