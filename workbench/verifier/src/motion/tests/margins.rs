//! Turns at constant rate whose gap is smaller than the error of a stretch: accepted where no point can be off along
//! the direction, refused where one can.

use super::super::answer::{Encounter, FirstContactAnswer, MovingDirection};
use super::super::check::{MovingBody, check_first_contact};
use super::super::path::Motion;
use super::{ORIGIN, X, cube, free, half_turn, moved};
use crate::Verdict;

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A gap above the error of the ends of a stretch, and far below that between them in the smallest part of an interval.
const GAP: f64 = 1.0 / (1u64 << 50) as f64;

fn turn(axis: [f64; 3], angle: f64, translation: [f64; 3]) -> Motion {
    Motion::ConstantRate { axis_point: ORIGIN, axis, angle, translation }
}

/// The verdict on one interval with a direction, of bodies with these centres and generators.
fn told([a, b]: [[f64; 3]; 2], generators: &[Vec<f64>], motions: [&Motion; 2], direction: MovingDirection) -> Verdict {
    let body = |center, motion| MovingBody { center, generators, motion };
    let answer = FirstContactAnswer { encounter: Encounter::Separate, intervals: vec![free(0.0, 1.0, direction)] };
    check_first_contact([body(&a, motions[0]), body(&b, motions[1])], 0.5, &answer).in_words()
}

#[test]
fn one_turn_beside_a_body_at_rest_has_no_margin() {
    let points =
        |gap: f64, motions: [&Motion; 2]| told([X, [1.0 + gap, 0.0, 0.0]], &[], motions, MovingDirection::Space(X));
    let rest = Motion::Rest;
    for angle in [1.0, -1.0, 0.5] {
        let turning = turn(Z, angle, ORIGIN);
        // the point leaves the other one along the circle
        assert!(points(GAP, [&turning, &rest]).is_right(), "{angle}");
        assert!(points(0.0, [&turning, &rest]).is_wrong(), "{angle}: they touch at the start");
        assert!(points(-GAP, [&turning, &rest]).is_wrong(), "{angle}");
        // rest is a turn by no angle, too, and pieces that stay
        assert!(points(GAP, [&turning, &turn(X, 0.0, ORIGIN)]).is_right(), "{angle}");
        assert!(points(GAP, [&turning, &moved(ORIGIN)]).is_right(), "{angle}");
        // where anything else moves, the clock of the turn matters, and the error of a stretch is above the gap
        for other in [moved(Z), turn(Z, angle / 2.0, ORIGIN)] {
            assert!(points(GAP, [&turning, &other]).is_wrong(), "{angle} {other:?}");
        }
        assert!(points(GAP, [&turn(Z, angle, Z), &rest]).is_wrong(), "{angle}: it goes along its axis");
    }
}

#[test]
fn a_gap_narrower_than_the_sines_that_show_it_is_not_called_false() {
    // a point turns by the double below half a turn, and its cosine misses 1 by 7.5e-33
    let half = turn(Z, std::f64::consts::PI, ORIGIN);
    let beside = |x: f64| {
        let bodies = [[-1.0, 0.0, 0.0], [x, 0.0, 0.0]];
        told(bodies, &[], [&half, &Motion::Rest], MovingDirection::Space(X))
    };
    assert!(beside(1.0_f64.next_up()).is_right());
    assert!(beside(1.0).is_right());
    assert!(beside(1.0_f64.next_down()).is_wrong());
    // a point turns by 1, and a segment reaches the cosine of 1 but for 1e-48 of it
    let one = turn(Z, 1.0, ORIGIN);
    let parts = [0.5403023058681397, 6.341275633647147e-17, 9.579366874489214e-33];
    let reaching = |last: f64| {
        let point = MovingBody { center: &X, generators: &[], motion: &one };
        let (center, generators) = ([parts[0], 0.0, 0.0], [parts[1], last].map(|part| vec![part, 0.0, 0.0]));
        let segment = MovingBody { center: &center, generators: &generators, motion: &Motion::Rest };
        let intervals = vec![free(0.0, 1.0, MovingDirection::Space([-1.0, 0.0, 0.0]))];
        let answer = FirstContactAnswer { encounter: Encounter::Separate, intervals };
        check_first_contact([point, segment], 0.5, &answer).in_words()
    };
    assert!(reaching(parts[2] * 0.99).is_right());
    assert!(matches!(reaching(parts[2]), Verdict::Unchecked(_)), "{:?}", reaching(parts[2]));
    assert!(reaching(parts[2] * 1.01).is_wrong());
}

#[test]
fn one_turn_has_no_margin_whichever_body_turns() {
    let points = |gap: f64, motions: [&Motion; 2]| {
        told([[1.0 + gap, 0.0, 0.0], X], &[], motions, MovingDirection::Space([-1.0, 0.0, 0.0]))
    };
    let turning = turn(Z, 1.0, ORIGIN);
    assert!(points(GAP, [&Motion::Rest, &turning]).is_right());
    assert!(points(0.0, [&Motion::Rest, &turning]).is_wrong());
    assert!(points(GAP, [&moved(Z), &turning]).is_wrong());
}

#[test]
fn a_turn_that_goes_too_far_is_refused_without_a_margin_as_well() {
    // it begins a quarter of a radian before the direction and goes past it
    let center = [0.968_912_421_710_644_7, -0.247_403_959_254_522_94, 0.0];
    let points = |gap: f64, angle: f64| {
        let motions = [&turn(Z, angle, ORIGIN), &Motion::Rest];
        told([center, [1.0 + gap, 0.0, 0.0]], &[], motions, MovingDirection::Space(X))
    };
    assert!(points(1e-6, 0.5).is_right() && points(-1e-6, 0.5).is_wrong());
    assert!(points(-1e-6, 0.125).is_right(), "it stops before");
}

#[test]
fn along_the_axis_there_is_no_margin() {
    let cube = cube(1.0);
    let cubes = |gap: f64, motions: [&Motion; 2], direction| {
        told([ORIGIN, [0.0, 0.0, 2.0 + 4.0 * gap]], &cube, motions, direction)
    };
    let (sideways, still) = (turn(Z, 3.0, [5.0, 0.0, 0.0]), Motion::Rest);
    for direction in [MovingDirection::Space(Z), MovingDirection::A(Z)] {
        assert!(cubes(GAP, [&sideways, &still], direction).is_right(), "{direction:?}");
        assert!(cubes(0.0, [&sideways, &still], direction).is_wrong(), "{direction:?}: they touch");
        assert!(cubes(-GAP, [&sideways, &still], direction).is_wrong(), "{direction:?}");
    }
    let other = turn(Z, -2.0, [0.0, 1.0, 0.0]);
    assert!(cubes(GAP, [&sideways, &other], MovingDirection::Space(Z)).is_right(), "both turn about the direction");
    // the bodies come nearer along the axis by more than the gap
    let nearer = turn(Z, 3.0, [0.0, 0.0, 8.0 * GAP]);
    assert!(cubes(GAP, [&nearer, &still], MovingDirection::Space(Z)).is_wrong());
}

#[test]
fn across_the_axis_there_is_a_margin() {
    let spinning = [1.0, 0.0, 0.0];
    let points = |gap: f64, axis: [f64; 3], direction| {
        let motions = [&turn(axis, 1.0, [1.0, 0.0, 0.0]), &Motion::Rest];
        told([Z, [0.0, 0.0, 1.0 + gap]], &[], motions, direction)
    };
    // the gap grows in truth, by 1 − cos t
    assert!(points(GAP, spinning, MovingDirection::Space(Z)).is_wrong());
    assert!(points(1e-6, spinning, MovingDirection::Space(Z)).is_right());
    assert!(points(GAP, Z, MovingDirection::Space(Z)).is_right(), "about the direction, the point stays");
}

#[test]
fn quaternions_that_go_linearly_have_no_margin() {
    let cube = cube(1.0);
    let piece = half_turn(ORIGIN);
    let cubes = |gap: f64| {
        told([ORIGIN, [0.0, 0.0, 2.0 + 4.0 * gap]], &cube, [&piece, &moved([1.0, 0.0, 0.0])], MovingDirection::Space(Z))
    };
    assert!(cubes(GAP).is_right() && cubes(0.0).is_wrong());
}
