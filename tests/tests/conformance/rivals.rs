//! The methods that are here only to be raced: right where floating point leaves no doubt, and never without an end.

use families::drawn::bodies::families;
use proptest::prelude::*;
use rivals::by_gjk::{GjkAnswer, STEPS, locate};
use tests::body_questions::asked;
use tests::runner::for_all;
use zonotope::collision::{Query, brute_force};
use zonotope::tally::{Operation, OperationCounts};

/// The questions of a long run for each of the fourteen families in space: 21,700 in all.
const CASES: u32 = 1550;

/// The questions of a long run about random bodies that the point is far from touching.
const CLEAR_CASES: u32 = 2000;

fn vector() -> impl Strategy<Value = [f64; 3]> {
    [-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64]
}

#[test]
fn gjk_is_right_far_from_touching() {
    let questions = (proptest::collection::vec(vector(), 3..9), vector(), 0.1..6.0f64);
    for_all(&questions, CLEAR_CASES, |(generators, p, size)| {
        let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let question = Query::new([0.0; 3], p.map(|v| v * size), &generators).expect("finite");
        let gauge = brute_force::gauge(&question).value;
        prop_assume!(!(0.999..1.001).contains(&gauge));
        let mut counts = OperationCounts::default();
        match locate(&question, &mut counts) {
            GjkAnswer::Intersecting => prop_assert!(gauge < 1.0),
            GjkAnswer::Disjoint { direction } => {
                let reach: f64 = generators.iter().map(|g| dot(g, &direction).abs()).sum();
                prop_assert!(gauge > 1.0 && dot(&question.to(), &direction) > reach);
            }
            GjkAnswer::GaveUp => prop_assert!(false, "gave up at a gauge of {}", gauge),
        }
        prop_assert!(counts.get(Operation::SearchStep) <= u64::from(STEPS));
        Ok(())
    });
}

/// In floating point without proof, but never with a panic or without end.
#[test]
fn gjk_always_ends() {
    for (_, generators) in families::<3>(8) {
        for_all(&asked(generators), CASES, |asked| {
            locate(&asked.displacement(), &mut ());
            Ok(())
        });
    }
}

#[test]
fn gjk_in_other_dimensions_and_of_degenerate_bodies() {
    let ask = |to, generators: &[[f64; 2]]| locate(&Query::new([0.0; 2], to, generators).expect("finite"), &mut ());
    assert_eq!(ask([0.0, 0.0], &[]), GjkAnswer::Intersecting);
    assert!(matches!(ask([1e-9, 0.0], &[[0.0; 2]]), GjkAnswer::Disjoint { .. }));
    assert_eq!(ask([0.5, 0.0], &[[1.0, 0.0]]), GjkAnswer::Intersecting);
    assert_eq!(ask([1.0, 0.0], &[[f64::MAX; 2]; 3]), GjkAnswer::GaveUp);
    let line = Query::new([0.0], [1.5], &[[1.0], [0.25]]).map(|question| locate(&question, &mut ()));
    assert!(matches!(line, Ok(GjkAnswer::Disjoint { .. })));
}
