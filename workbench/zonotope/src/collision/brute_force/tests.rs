//! Squares, cubes and flat bodies by hand.

use super::*;
use crate::interop::verifier::check_location;

fn ask<const D: usize>(to: [f64; D], generators: &[[f64; D]]) -> (&'static str, Option<Rational>) {
    let question = Query::new([0.0; D], to, generators).expect("finite");
    let location = locate(&question);
    assert_eq!(check_location(&question, &location).proof().map(drop), Ok(()), "{location:?}");
    (location.status().name(), exact_gauge(&question))
}

fn ratio(numerator: i64, denominator: u64) -> Option<Rational> {
    Some(Rational::from_parts(numerator.into(), denominator.into()))
}

#[test]
fn a_square_by_hand() {
    let square = [[1.0, 0.0], [0.0, 1.0]];
    assert_eq!(ask([0.5, -0.75], &square), ("inside", ratio(3, 4)));
    assert_eq!(ask([1.0, 1.0], &square), ("boundary", ratio(1, 1)));
    assert_eq!(ask([1.5, 0.0], &square), ("outside", ratio(3, 2)));
    assert_eq!(ask([0.0, 0.0], &square), ("inside", ratio(0, 1)));
}

#[test]
fn parallel_and_zero_generators_add_up() {
    let doubled = [[1.0, 0.0], [0.0, 0.0], [-2.0, 0.0], [0.0, 3.0]];
    assert_eq!(ask([3.0, 1.0], &doubled), ("boundary", ratio(1, 1)));
    assert_eq!(ask([1.0, 1.0], &doubled), ("inside", ratio(1, 3)));
}

#[test]
fn flat_bodies_have_no_inside() {
    let flat = [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [2.0, 0.0, 0.0]];
    assert_eq!(ask([0.1, 0.0, 0.0], &flat).0, "boundary");
    assert_eq!(ask([0.0, 0.0, f64::from_bits(1)], &flat), ("outside", None));
    assert_eq!(ask([4.5, 0.0, 0.0], &flat), ("outside", ratio(9, 8)));
}

#[test]
fn no_generators_leave_the_origin() {
    assert_eq!(ask([0.0, 0.0, 0.0], &[]), ("boundary", ratio(0, 1)));
    assert_eq!(ask([0.0, 1e-300, 0.0], &[[0.0; 3]]), ("outside", None));
    assert_eq!(ask([0.0], &[]), ("boundary", ratio(0, 1)));
}

#[test]
fn the_displacement_is_exact() {
    let generators = [[1e16]];
    let question = Query::new([-1.0], [1e16], &generators).expect("finite");
    assert_eq!(locate(&question).status().name(), "outside");
    let gauge = gauge(&question);
    assert_eq!((gauge.value, gauge.error > 0.0), (1.0, true));
}

/// The middle of a facet whose normal has no doubles, moved outward by the smallest denormal: any rounded normal meets
/// the edges of the facet by far more than that.
#[test]
fn a_gap_too_narrow_for_doubles() {
    let generators = [[1.0, 1.0 / 3.0, 0.1], [0.2, 1.0, 1.0 / 7.0], [0.25, 0.5, 1.0]];
    for step in [-1.0, 1.0] {
        let from = [0.0, 0.0, step * f64::from_bits(1)];
        let question = Query::new(from, generators[2], &generators).expect("finite");
        let location = locate(&question);
        assert_eq!(check_location(&question, &location).proof().map(drop), Ok(()));
        let narrow = matches!(location, Location::Outside(Separation::Exact(_)));
        assert_eq!((narrow, location.status().name()), (step < 0.0, if step < 0.0 { "outside" } else { "inside" }));
    }
}
