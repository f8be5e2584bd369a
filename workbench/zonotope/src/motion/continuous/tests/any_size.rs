//! Numbers at the ends of the range of doubles, sizes that differ by all of it, and short times: the verifier accepts
//! the answer of every method.

use super::Zonotope;
use crate::interop::verifier::check_first_contact;
use crate::motion::continuous::by_control_points::DEFAULT_RESOLUTION;
use crate::motion::continuous::{FirstContact, Method};
use crate::motion::{Motion, MotionPiece};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// A motion with the numbers that state it.
#[derive(Debug, Clone)]
struct Stated {
    motion: Motion,
    question: ::verifier::Motion,
}

impl Stated {
    fn constant_rate(axis_point: [f64; 3], axis: [f64; 3], angle: f64, translation: [f64; 3]) -> Self {
        Self {
            motion: Motion::constant_rate(axis_point, axis, angle, translation).expect("an axis"),
            question: ::verifier::Motion::ConstantRate { axis_point, axis, angle, translation },
        }
    }

    fn pieces(parts: &[MotionPiece]) -> Self {
        let piece = |part: &MotionPiece| {
            let MotionPiece { until, from, to, axis_point, translation } = *part;
            ::verifier::MotionPiece { until, from, to, axis_point, translation }
        };
        Self {
            motion: Motion::from_pieces(parts).expect("a motion"),
            question: ::verifier::Motion::Pieces(parts.iter().map(piece).collect()),
        }
    }

    fn translation(translation: [f64; 3]) -> Self {
        let still = [1.0, 0.0, 0.0, 0.0];
        Self::pieces(&[MotionPiece { until: 1.0, from: still, to: still, axis_point: [0.0; 3], translation }])
    }
}

/// Asks every method, gives each answer to the verifier, and holds them to each other; their cases.
fn cases_of_all_methods(bodies: [&Zonotope<3>; 2], motions: [&Stated; 2]) -> Vec<&'static str> {
    let ask = |method: Method| {
        let found = method.first_contact(bodies, motions.map(|stated| &stated.motion), DEFAULT_RESOLUTION, &mut ());
        let verdict = check_first_contact(bodies, motions.map(|stated| &stated.question), DEFAULT_RESOLUTION, &found);
        assert!(!verdict.is_wrong(), "{method:?}: {verdict:?}: {found:?} to {bodies:?} {motions:?}");
        found.name()
    };
    let cases = Method::ALL.map(ask).to_vec();
    assert!(!(cases.contains(&"separate") && cases.contains(&"contact")), "{cases:?}: {bodies:?} {motions:?}");
    cases
}

const SIZES: [f64; 9] = [0.0, 5e-324, 1e-308, 1e-170, 1e-12, 1.0, 1e12, 1e170, 1e308];

fn box_of(center: [f64; 3], [x, y, z]: [f64; 3]) -> Zonotope<3> {
    Zonotope::new(center, vec![[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]).expect("finite")
}

#[test]
fn bodies_and_translations_at_the_ends_of_the_doubles_have_answers_that_verify() {
    for size in SIZES {
        for gone in SIZES {
            for place in SIZES {
                let bodies = [box_of([0.0; 3], [size; 3]), box_of([place, 0.0, 0.0], [size; 3])];
                let turned = Stated::constant_rate([size, 0.0, 0.0], [0.0, 1.0, 1.0], 2.0, [gone, 0.0, 0.0]);
                for first in [Stated::translation([gone, gone, 0.0]), turned] {
                    let rest = Stated::translation([0.0; 3]);
                    cases_of_all_methods(bodies.each_ref(), [&first, &rest]);
                }
            }
        }
    }
}

/// Angles, axes, axis points and quaternions of any size beside bodies and translations of any size.
#[test]
fn numbers_of_any_size_have_answers_that_verify() {
    let mut rng = Pcg64::seed_from_u64(12);
    let number = |rng: &mut Pcg64| -> f64 {
        let size = if rng.random_bool(0.4) { 1.0 } else { *SIZES.choose(rng).expect("sizes") };
        size * rng.random_range(-1.0..1.0)
    };
    let vector = |rng: &mut Pcg64| [0, 1, 2].map(|_| number(rng));
    let mut drawn = 0;
    while drawn < crate::property_cases::config(200).cases {
        let bodies = [0, 1].map(|_| {
            let count = rng.random_range(0..4);
            Zonotope::new(vector(&mut rng), (0..count).map(|_| vector(&mut rng)).collect()).expect("finite")
        });
        let motions = [0, 1].map(|_| {
            if rng.random_bool(0.5) {
                let axis = vector(&mut rng);
                let axis = if axis == [0.0; 3] { [0.0, 0.0, 5e-324] } else { axis };
                return Some(Stated::constant_rate(vector(&mut rng), axis, number(&mut rng), vector(&mut rng)));
            }
            let first = *[5e-324, 1e-200, 1e-100, 0.5].choose(&mut rng).expect("times");
            let parts = [first, 1.0].map(|until| MotionPiece {
                until,
                from: [0, 1, 2, 3].map(|_| number(&mut rng)),
                to: [0, 1, 2, 3].map(|_| number(&mut rng)),
                axis_point: vector(&mut rng),
                translation: vector(&mut rng),
            });
            Motion::from_pieces(&parts).is_ok().then(|| Stated::pieces(&parts))
        });
        // two quaternions may be more than half a turn apart
        let [Some(first), Some(second)] = &motions else { continue };
        cases_of_all_methods(bodies.each_ref(), [first, second]);
        drawn += 1;
    }
}

/// A piece of which products of lengths of time leave the doubles is placed as a longer one is.
#[test]
fn a_short_piece_places_a_body_as_a_long_one_does() {
    for until in [5e-324, 1e-310, 3e-162, 1e-155, 1e-100, 1e-20] {
        for small in [1e-300, 1e-160, 1e-154, 1.0] {
            let turn = |until| MotionPiece {
                until,
                from: [small, 0.0, 0.0, 0.0],
                to: [3.0, 1.0, -2.0, 1.0],
                axis_point: [1.0, 2.0, 3.0],
                translation: [1.0, 0.0, -1.0],
            };
            let still = [1.0, 0.0, 0.0, 0.0];
            let rest = MotionPiece { until: 1.0, from: still, to: still, axis_point: [0.0; 3], translation: [0.0; 3] };
            let [short, long] = [until, 0.5].map(|until| Motion::from_pieces(&[turn(until), rest]).expect("a motion"));
            for (early, late) in [(0.0, 0.0), (until, 0.5), (1.0, 1.0)] {
                let [p, q] = [short.pose_at(early), long.pose_at(late)].map(|pose| pose.expect("finite"));
                for (p, q) in p.rows().as_flattened().iter().zip(q.rows().as_flattened()) {
                    assert!((p - q).abs() < 1e-14, "{until} {small}: {p} {q}");
                }
            }
        }
    }
    // bodies that rest are not said to be free by a quaternion that seems not to turn
    let (bar, cube) = (box_of([3.0, 0.0, 0.0], [2.0, 0.1, 0.1]), box_of([0.0, 4.0, 0.0], [1.0; 3]));
    let quarter = |until| MotionPiece {
        until,
        from: [1.0, 0.0, 0.0, 0.0],
        to: [1.0, 0.0, 0.0, 1.0],
        axis_point: [0.0; 3],
        translation: [0.0; 3],
    };
    let still = Stated::translation([0.0; 3]);
    let rest = MotionPiece { to: [1.0, 0.0, 0.0, 0.0], ..quarter(1.0) };
    for until in [5e-324, 1e-170, 1e-100] {
        let turning = Stated::pieces(&[quarter(until), rest]);
        let cases = cases_of_all_methods([&bar, &cube], [&turning, &still]);
        assert!(cases.iter().all(|case| *case != "separate"), "{until}: {cases:?}");
    }
    let found = Method::default().first_contact(
        [&bar, &cube],
        [&Stated::pieces(&[quarter(0.5), rest]).motion, &still.motion],
        DEFAULT_RESOLUTION,
        &mut (),
    );
    assert!(matches!(found, FirstContact::Contact { .. }), "{found:?}");
}
