//! First contacts by hand: bodies and motions whose gaps are known, and certificates that do not prove them.

use super::answer::{Encounter, FirstContactAnswer, FreeInterval, MovingDirection};
use super::check::{MovingBody, check_first_contact, check_times};
use super::path::{Motion, MotionPiece};
use crate::Verdict;

mod margins;

fn cube(side: f64) -> Vec<Vec<f64>> {
    vec![vec![side, 0.0, 0.0], vec![0.0, side, 0.0], vec![0.0, 0.0, side]]
}

const IDENTITY: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

fn moved(translation: [f64; 3]) -> Motion {
    let [from, to] = [IDENTITY; 2];
    Motion::Pieces(vec![MotionPiece { until: 1.0, from, to, axis_point: [0.0; 3], translation }])
}

/// Half a turn about the third axis in two pieces.
fn half_turn(axis_point: [f64; 3]) -> Motion {
    let piece =
        |until| MotionPiece { until, from: IDENTITY, to: [1.0, 0.0, 0.0, 1.0], axis_point, translation: [0.0; 3] };
    Motion::Pieces(vec![piece(0.5), piece(1.0)])
}

fn at_constant_rate(angle: f64) -> Motion {
    Motion::ConstantRate { axis_point: [0.0; 3], axis: [0.0, 0.0, 2.0], angle, translation: [0.0; 3] }
}

fn free(from: f64, to: f64, direction: MovingDirection) -> FreeInterval {
    FreeInterval { from, to, direction }
}

fn verdict(centers: [[f64; 3]; 2], motions: [&Motion; 2], intervals: Vec<FreeInterval>, end: Encounter) -> Verdict {
    let cube = cube(1.0);
    let body = |i: usize| MovingBody { center: &centers[i], generators: &cube, motion: motions[i] };
    let answer = FirstContactAnswer { encounter: end, intervals };
    check_first_contact([body(0), body(1)], 1.0 / 1024.0, &answer).in_words()
}

fn is_separate(centers: [[f64; 3]; 2], motions: [&Motion; 2], intervals: Vec<FreeInterval>) -> bool {
    verdict(centers, motions, intervals, Encounter::Separate).is_right()
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const ORIGIN: [f64; 3] = [0.0; 3];

#[test]
fn cubes_that_pass_each_other() {
    let space = MovingDirection::Space(X);
    let apart = |x: f64, direction| {
        is_separate([ORIGIN, [x, -4.0, 0.0]], [&Motion::Rest, &moved([0.0, 8.0, 0.0])], vec![free(0.0, 1.0, direction)])
    };
    assert!(apart(2.5, space) && apart(2.0_f64.next_up(), space));
    assert!(!apart(2.0, space), "touching is no gap");
    assert!(!apart(2.5, MovingDirection::Space([-1.0, 0.0, 0.0])), "a reversed direction");
    assert!(!apart(2.5, MovingDirection::Space(ORIGIN)));
    assert!(apart(2.5, MovingDirection::A(X)) && apart(2.5, MovingDirection::B(X)));
    assert!(apart(2.5, MovingDirection::Edges([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])));
    assert!(!apart(2.5, MovingDirection::Edges([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])));
}

#[test]
fn a_cube_that_turns_beside_a_resting_one() {
    for turning in [half_turn(ORIGIN), at_constant_rate(std::f64::consts::PI), at_constant_rate(-40.0)] {
        let apart = |x: f64, direction| {
            is_separate([ORIGIN, [x, 0.0, 0.0]], [&turning, &Motion::Rest], vec![free(0.0, 1.0, direction)])
        };
        // its corner reaches the square root of 2
        assert!(apart(2.4143, MovingDirection::Space(X)), "{turning:?}");
        assert!(!apart(2.4142, MovingDirection::Space(X)), "{turning:?}");
        // it turns away from directions in its own frame
        assert!(!apart(2.5, MovingDirection::A(X)), "{turning:?}");
        assert!(apart(2.4143, MovingDirection::B(X)), "{turning:?}");
    }
}

#[test]
fn a_body_is_where_all_pieces_before_have_put_it() {
    // half a turn about (1, 0, 0) takes the first cube to (2, 0, 0), and then to (6, 0, 0)
    let Motion::Pieces(mut pieces) = half_turn(X) else { unreachable!("pieces") };
    pieces[1].until = 0.75;
    pieces.push(MotionPiece {
        until: 1.0,
        from: IDENTITY,
        to: IDENTITY,
        axis_point: [9.0; 3],
        translation: [4.0, 0.0, 0.0],
    });
    let motion = Motion::Pieces(pieces);
    let apart = |from: f64, to: f64, x: f64| {
        let intervals = vec![
            free(0.0, from, MovingDirection::Space([0.0, 0.0, 1.0])),
            free(from, to, MovingDirection::Space(X)),
            free(to, 1.0, MovingDirection::Space(X)),
        ];
        let away = Motion::Pieces(vec![
            MotionPiece { until: from, from: IDENTITY, to: IDENTITY, axis_point: ORIGIN, translation: [x, 0.0, 0.0] },
            MotionPiece { until: 1.0, from: IDENTITY, to: IDENTITY, axis_point: ORIGIN, translation: ORIGIN },
        ]);
        let body = cube(1.0);
        let flat = vec![vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 0.0]];
        let answer = FirstContactAnswer { encounter: Encounter::Separate, intervals };
        let first = MovingBody { center: &ORIGIN, generators: &flat, motion: &motion };
        let second = MovingBody { center: &[0.0, 0.0, 1.5], generators: &body, motion: &away };
        check_first_contact([first, second], 0.5, &answer).is_right()
    };
    assert!(apart(0.25, 0.5, 8.1) && !apart(0.25, 0.5, 7.9));
}

#[test]
fn intervals_follow_each_other() {
    let motions = [&Motion::Rest, &moved([0.0, 8.0, 0.0])];
    let direction = MovingDirection::Space(X);
    let told = |intervals: &[[f64; 2]], end: Encounter| {
        let intervals = intervals.iter().map(|&[from, to]| free(from, to, direction)).collect();
        verdict([ORIGIN, [2.5, 0.0, 0.0]], motions, intervals, end).is_right()
    };
    assert!(told(&[[0.0, 0.5], [0.5, 1.0]], Encounter::Separate));
    for wrong in [
        &[][..],
        &[[0.0, 0.5]],
        &[[0.0, 0.5], [0.6, 1.0]],
        &[[0.0, 0.6], [0.5, 1.0]],
        &[[0.5, 1.0], [0.0, 0.5]],
        &[[0.1, 1.0]],
        &[[0.0, 1.5]],
        &[[0.0, 0.0], [0.0, 1.0]],
        &[[0.0, f64::NAN]],
    ] {
        assert!(!told(wrong, Encounter::Separate), "{wrong:?}");
    }
}

#[test]
fn a_contact_by_its_coefficients() {
    // they touch at 1/2, when the centres are 2 apart
    let motions = [&Motion::Rest, &moved([-4.0, 0.0, 0.0])];
    let until = 0.5 - 1.0 / 1024.0;
    let contact = |time: [f64; 2], first: f64, basis: &[usize]| {
        let coefficients = vec![first, 0.0, 0.0, 1.0, 0.0, 0.0];
        let intervals = if time[0] > 0.0 { vec![free(0.0, time[0], MovingDirection::Space(X))] } else { Vec::new() };
        let end = Encounter::Contact { time, coefficients, basis: basis.to_vec() };
        verdict([ORIGIN, [4.0, 0.0, 0.0]], motions, intervals, end).is_right()
    };
    assert!(contact([until, 0.5], 1.0, &[0]) && contact([until, 0.5], 1.0, &[]));
    assert!(contact([until, 0.5], 1.0, &[0, 1, 2]));
    assert!(!contact([until, 0.5], 0.5, &[0]), "a coefficient that does not solve the system");
    assert!(!contact([until, 0.5], 0.5, &[1]), "a basis that does not lead there");
    assert!(!contact([until, 0.5], 1.0, &[0, 0]) && !contact([until, 0.5], 1.0, &[6]));
    assert!(!contact([until, 0.5 - 1.0 / 4096.0], 1.0, &[0]), "too early");
    assert!(!contact([0.5, 0.5], 1.0, &[0]), "no gap at the time of the contact");
    assert!(!contact([until - 1.0 / 4096.0, 0.5], 1.0, &[0]), "wider than the resolution");
    assert!(!contact([0.0, 0.5], 1.0, &[0]) && !contact([0.0, 0.0], 1.0, &[0]));
}

#[test]
fn a_contact_at_constant_rate_is_strictly_inside() {
    let quarter = at_constant_rate(std::f64::consts::FRAC_PI_2);
    // the other cube comes so fast that it is clear of the turning one just before the end
    let (coming, until) = (moved([-4096.0, 0.0, 0.0]), 1.0 - 1.0 / 1024.0);
    let at_the_end = |x: f64, [of_a, of_b]: [f64; 2], basis: &[usize]| {
        // the quarter turn takes the second edge of the cube to the first axis reversed
        let coefficients = vec![0.0, -of_a, 0.0, of_b, 0.0, 0.0];
        let end = Encounter::Contact { time: [until, 1.0], coefficients, basis: basis.to_vec() };
        let before = vec![free(0.0, until, MovingDirection::Space(X))];
        verdict([ORIGIN, [4096.0 + x, 0.0, 0.0]], [&quarter, &coming], before, end).is_right()
    };
    assert!(at_the_end(1.5, [0.5, 1.0], &[0, 1, 2]));
    assert!(!at_the_end(1.5, [0.5, 1.0], &[0, 1]), "placements that are enclosed have a basis of three");
    assert!(at_the_end(2.0, [1.0, 1.0], &[0, 1, 2]), "the double below a quarter turn leaves an overlap of 6e-17");
    assert!(!at_the_end(2.0 + 2f64.powi(-40), [1.0, 1.0], &[0, 1, 2]), "not inside");
    assert!(!at_the_end(1.5, [0.6, 1.0], &[0, 1, 2]), "written otherwise");
}

#[test]
fn a_contact_before_any_turn_is_where_the_bodies_are() {
    let quarter = at_constant_rate(std::f64::consts::FRAC_PI_2);
    let at_start = |x: f64, first: f64| {
        let coefficients = vec![first, 0.0, 0.0, 1.0, 0.0, 0.0];
        let end = Encounter::Contact { time: [0.0, 0.0], coefficients, basis: vec![0, 1, 2] };
        verdict([ORIGIN, [x, 0.0, 0.0]], [&quarter, &Motion::Rest], Vec::new(), end).is_right()
    };
    assert!(at_start(1.5, 0.5) && at_start(2.0, 1.0), "no turn is not rounded");
    assert!(!at_start(1.5, 0.6) && !at_start(2.0_f64.next_up(), 1.0));
}

#[test]
fn two_points_near_each_other() {
    let grazing = |motion: &Motion, distance_at_most: f64| {
        let end = Encounter::Grazing { time: [0.0, 0.25], distance_at_most };
        verdict([ORIGIN, [4.0, 0.0, 0.0]], [&Motion::Rest, motion], Vec::new(), end)
    };
    let straight = moved([-4.0, 0.0, 0.0]);
    assert!(grazing(&straight, 1.0).is_right() && grazing(&straight, 1.5).is_right());
    assert!(grazing(&straight, 1.0_f64.next_down()).is_wrong() && grazing(&straight, -1.0).is_wrong());
    assert!(grazing(&straight, f64::NAN).is_wrong());
    // a turn about the first axis leaves the distance as it is, but for what encloses it
    let turning = Motion::ConstantRate { axis_point: ORIGIN, axis: X, angle: 2.0, translation: [-4.0, 0.0, 0.0] };
    assert!(grazing(&turning, 1.0 + 1e-12).is_right() && grazing(&turning, 1.0 - 1e-12).is_wrong());
    assert!(matches!(grazing(&turning, 1.0), Verdict::Unchecked(_)));
}

#[test]
fn what_is_no_motion_has_no_answer() {
    let piece = MotionPiece { until: 1.0, from: IDENTITY, to: IDENTITY, axis_point: ORIGIN, translation: ORIGIN };
    let pieces = |changed: MotionPiece| Motion::Pieces(vec![changed]);
    let zero = Motion::ConstantRate { axis_point: ORIGIN, axis: ORIGIN, angle: 1.0, translation: ORIGIN };
    for wrong in [
        zero,
        at_constant_rate(f64::NAN),
        Motion::Pieces(Vec::new()),
        pieces(MotionPiece { until: 0.5, ..piece }),
        pieces(MotionPiece { from: [0.0; 4], ..piece }),
        pieces(MotionPiece { to: [-1.0, 0.0, 0.0, 0.1], ..piece }),
        pieces(MotionPiece { translation: [f64::INFINITY, 0.0, 0.0], ..piece }),
    ] {
        let intervals = vec![free(0.0, 1.0, MovingDirection::Space(X))];
        let told = verdict([ORIGIN, [9.0, 0.0, 0.0]], [&wrong, &Motion::Rest], intervals, Encounter::Separate);
        assert!(told.is_wrong(), "{wrong:?}: {told:?}");
    }
}

#[test]
fn cubes_that_touch_are_within_a_distance_of_zero() {
    let told = |x: f64| {
        let end = Encounter::Grazing { time: [0.0, 0.25], distance_at_most: 0.0 };
        verdict([ORIGIN, [x, 0.0, 0.0]], [&Motion::Rest; 2], Vec::new(), end)
    };
    assert!(told(2.0).is_right() && told(1.5).is_right());
    assert!(told(2.0_f64.next_up()).is_wrong());
}

#[test]
fn a_point_that_turns_about_itself_touches_a_face_where_its_coefficient_is_one() {
    // The point comes from (3, 0, 0) to the face of the cube at (1, 0, 0), and its axis comes with it
    let cube = cube(1.0);
    let until = 1.0 - 1.0 / 1024.0;
    let told = |x: f64| {
        let motion =
            Motion::ConstantRate { axis_point: [x, 0.0, 0.0], axis: X, angle: 1.0, translation: [-2.0, 0.0, 0.0] };
        let end = Encounter::Contact { time: [until, 1.0], coefficients: vec![1.0, 0.0, 0.0], basis: vec![0, 1, 2] };
        let answer =
            FirstContactAnswer { encounter: end, intervals: vec![free(0.0, until, MovingDirection::Space(X))] };
        let first = MovingBody { center: &ORIGIN, generators: &cube, motion: &Motion::Rest };
        let second = MovingBody { center: &[x, 0.0, 0.0], generators: &[], motion: &motion };
        check_first_contact([first, second], 1.0 / 1024.0, &answer).in_words()
    };
    assert!(told(3.0).is_right(), "{:?}", told(3.0));
    assert!(told(3.0_f64.next_up()).is_wrong());
}

#[test]
fn two_times_of_an_encounter_go_up_from_zero_to_one() {
    assert!(check_times([0.0, 1.0]).is_ok() && check_times([0.5, 0.5]).is_ok());
    for wrong in [[-0.5, 0.5], [0.5, 0.25], [0.5, 1.5], [1.5, 0.5], [f64::NAN, 0.5], [0.5, f64::NAN]] {
        assert!(check_times(wrong).is_err(), "{wrong:?}");
    }
}
