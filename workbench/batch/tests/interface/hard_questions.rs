//! Questions of few numbers that ask much of the geometry: parallel generators, neighbouring doubles, denormals, flat
//! bodies. Each is answered soon, and the verifier proves the whole answer.

use std::time::{Duration, Instant};

use batch::{Verdict, answer, verify};
use serde_json::Value;

/// The time for each question. The least of some tries is held to it, as a loaded machine may interrupt one of them.
const LIMIT: Duration = Duration::from_millis(500);
const TRIES: usize = 4;

#[test]
fn hard_questions_are_answered_soon_and_proved_whole() {
    for line in include_str!("hard_questions.jsonl").lines() {
        let answered = answer(line);
        let verdict = verify(line, &answered);
        assert!(matches!(verdict, Verdict::Right(_)), "{verdict:?}: {line} {answered}");
        let soon = (0..TRIES).any(|_| {
            let begin = Instant::now();
            assert_eq!(answer(line), answered, "{line}");
            begin.elapsed() < LIMIT
        });
        assert!(soon, "{line}");
    }
}

/// The values of the distances in the file, the nearest doubles of the exact ones.
#[test]
fn distances_of_bodies_that_are_nearly_equal_have_their_values() {
    let ulp = f64::EPSILON;
    for (name, expected) in [
        ("cubes whose sides are neighbouring doubles", 3f64.sqrt() * ulp),
        ("points that the smallest double separates", 5e-324),
        ("a body from itself", 0.0),
        // The ends of the segments differ by (1, −4, −1) ulps.
        ("parallel generators, neighbouring doubles, far centres", 18f64.sqrt() * ulp),
    ] {
        let line = include_str!("hard_questions.jsonl").lines().find(|line| line.contains(name)).expect("a question");
        let answer: Value = serde_json::from_str(&answer(line)).expect("an answer is JSON");
        let value = answer["result"]["value"].as_f64().expect("a value");
        assert!((value - expected).abs() <= 4.0 * ulp * expected, "{name}: {value} {expected}");
        let bounds = ["lower", "upper"].map(|bound| answer["result"][bound].as_f64().expect("a bound"));
        assert!(bounds[0] <= value && value <= bounds[1], "{name}: {bounds:?} {value}");
    }
}
