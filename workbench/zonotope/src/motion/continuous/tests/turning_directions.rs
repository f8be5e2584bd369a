//! Directions that turn with a body at constant rate prove a gap along themselves: they turn as the motion does, and
//! not as the stretch of a linear quaternion that encloses it.

use super::*;
use crate::motion::quaternion::image;
use crate::numeric::linear::{cross, dot};
use crate::zonotope::pose::Pose;

/// The gap along a direction of a stretch at a time, in doubles, over the direction's length.
fn gap_at(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2], direction: &SeparatingDirection, time: f64) -> f64 {
    let poses = motions.map(|motion| motion.pose_at(time).expect("in range"));
    let turned = |pose: &Pose, v: &[f64; 3]| image(pose.rows(), v);
    let u = match direction {
        SeparatingDirection::Space(u) => *u,
        SeparatingDirection::First(u) => turned(&poses[0], u),
        SeparatingDirection::Second(u) => turned(&poses[1], u),
        SeparatingDirection::Edges([e, f]) => cross(&turned(&poses[0], e), &turned(&poses[1], f)),
    };
    let [first, second] = [(0, 1.0), (1, -1.0)].map(|(i, sign): (usize, f64)| {
        let reach: f64 = bodies[i].generators().iter().map(|g| dot(&u, &turned(&poses[i], g)).abs()).sum();
        let (center, moved) = (turned(&poses[i], &bodies[i].center()), poses[i].translation());
        dot(&u, &[0, 1, 2].map(|k| center[k] + moved[k])) + sign * reach
    });
    (second - first) / dot(&u, &u).sqrt()
}

/// Asks for the first contact and holds every direction to the motion; how many of them turn with a body.
fn turning_directions_hold(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2]) -> usize {
    let answer = first_contact(bodies, motions);
    for stretch in answer.free() {
        for part in 0..=32 {
            let time = stretch.from + (stretch.until - stretch.from) * f64::from(part) / 32.0;
            let gap = gap_at(bodies, motions, &stretch.direction, time);
            assert!(gap > -1e-12, "{gap} at {time} along {:?}", stretch.direction);
        }
    }
    answer.free().iter().filter(|stretch| !matches!(stretch.direction, SeparatingDirection::Space(_))).count()
}

/// A plate that turns beside a small cube, much wider than the cube's distance from the axis.
#[test]
fn a_wide_body_is_not_passed_by_the_reach_of_the_other() {
    let cube = Zonotope::new([0.0; 3], vec![[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]).expect("finite");
    let plate = Zonotope::new([1.2, 0.0, 0.0], vec![[0.1, 0.0, 0.0], [0.0, 100.0, 0.0], [0.0, 0.0, 1.0]]);
    let plate = plate.expect("finite");
    let turn = MotionPiece {
        until: 1.0,
        from: [1.0, 0.0, 0.0, 0.0],
        to: [libm::cos(0.75), 0.0, 0.0, libm::sin(0.75)],
        axis_point: [0.0; 3],
        translation: [0.0; 3],
    };
    let rational = Motion::from_pieces(&[turn]).expect("a motion");
    for far in [0.0, 1.0, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7, 2.8] {
        let along = [far * libm::sin(1.5), -far * libm::cos(1.5), 0.0];
        let turning = Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], 1.5, along).expect("a motion");
        turning_directions_hold([&cube, &plate], [&turning, &rational]);
        turning_directions_hold([&plate, &cube], [&rational, &turning]);
    }
}

#[test]
fn random_bodies_that_turn_at_constant_rate() {
    let mut rng = Pcg64::seed_from_u64(7);
    let mut turning = 0;
    for round in 0..300 {
        let bodies =
            [2, 3].map(|generators| random_body(&mut rng, generators, if round % 3 == 0 { 10.0 } else { 1.0 }));
        let mut motion = |is_rational: bool| {
            let mut vector = |size: f64| [0, 1, 2].map(|_| size * rng.random_range(-1.0..1.0));
            let (point, axis, translation) = (vector(2.0), vector(1.0), vector(4.0));
            if is_rational {
                return Motion::from_pieces(&random_parts(&mut rng, 1)).expect("a motion");
            }
            let angle = rng.random_range(-6.0..6.0);
            Motion::constant_rate(point, axis, angle, translation).expect("a motion")
        };
        let motions = [motion(round % 4 == 0), motion(round % 4 == 1)];
        turning += turning_directions_hold(bodies.each_ref(), motions.each_ref());
    }
    assert!(turning > 40, "{turning} directions turn with a body");
}
