//! Every method against exact placements, and volumes against each other.

use std::f64::consts::{PI, TAU};

use super::brute_force::{farthest_squared, holds_placement};
use super::parts::plane::Plane;
use super::parts::scaled_body::ScaledBody;
use super::parts::shadow::Shadow;
use super::*;
use crate::motion::{KeyPose, Motion, MotionPiece};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::euclidean_norm;
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;
use families::bodies::named;
use proptest::prelude::*;

/// Numbers t of placements of a sweep: half of the angle has the tangent t |axis|, and the angle is not above that of
/// the sweep. The last one is next to the end.
fn turns(sweep: &Sweep, count: u32) -> Vec<f64> {
    let exponent = sweep.axis.iter().filter_map(|c| crate::numeric::scaling::binary_exponent(*c)).max().unwrap_or(0);
    let scaled = sweep.axis.map(|c| crate::numeric::scaling::scale_by_power_of_two(c, -i64::from(exponent)));
    let length = euclidean_norm(&scaled);
    let largest = sweep.angle.min(TAU * 0.999_999);
    (0..=count)
        .map(|i| {
            let angle = largest * f64::from(i) / f64::from(count);
            let tangent = libm::tan(angle / 2.0) * (1.0 - 8.0 * f64::EPSILON * if angle < PI { 1.0 } else { -1.0 });
            crate::numeric::scaling::scale_by_power_of_two(tangent / length, -i64::from(exponent))
        })
        .filter(|t| t.is_finite())
        .collect()
}

fn check(sweep: &Sweep, body: &Zonotope<3>, count: u32) -> Result<(), TestCaseError> {
    for method in Method::ALL {
        let volume = match method.volume(sweep, body) {
            Ok(volume) => volume,
            Err(error) => {
                prop_assert_eq!(error, SweepError::OutOfRange);
                continue;
            }
        };
        // the zonogon around many arcs has many generators, and the truth tries all pairs
        let (turns, schedule) = if volume.generators().len() > 15 { (2, &[1.0][..]) } else { (count, &[0.0, 1.0][..]) };
        if volume.generators().len() > 40 {
            continue;
        }
        for t in self::turns(sweep, turns) {
            for s in schedule {
                prop_assert!(
                    holds_placement(&volume, sweep, body, t, *s),
                    "{}: {t:e} {s} of {sweep:?} for {body:?}: {volume:?}",
                    method.id()
                );
            }
        }
    }
    Ok(())
}

fn sweep(axis_point: [f64; 3], axis: [f64; 3], angle: f64, translation: [f64; 3]) -> Sweep {
    Sweep::new(axis_point, axis, angle, translation).expect("a sweep")
}

/// The body where a pose puts it, rounded outward.
fn image(body: &Zonotope<3>, pose: &Pose) -> Zonotope<3> {
    body.linear_image(&pose.matrix()).expect("in range").translated(pose.translation()).expect("in range")
}

fn body(center: [f64; 3], generators: &[[f64; 3]]) -> Zonotope<3> {
    Zonotope::new(center, generators.to_vec()).expect("finite")
}

#[test]
fn degenerate_sweeps_are_held() {
    let cube = &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]][..];
    let bodies = [
        body([3.0, 0.0, 0.0], &[]),
        body([0.0; 3], &[]),
        body([0.0; 3], cube),
        body([5.0, 1.0, -2.0], cube),
        body([1.0, 0.0, 0.0], &[[1.0, 0.0, 0.0]]),
        body([0.0, 0.0, 2.0], &[[0.0, 0.0, 1.0]]),
        body([1.0, 1.0, 0.0], &[[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0; 3]]),
        body([0.1, 0.2, 0.3], &[[0.3, 0.1, 0.7], [1e-9, 0.2, 0.0]]),
    ];
    let axes = [[0.0, 0.0, 1.0], [0.0, -2.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 3.0]];
    let angles = [5e-324, 1e-9, PI / 2.0, PI, 4.0, TAU, 30.0];
    for (i, body) in bodies.iter().enumerate() {
        for (k, axis) in axes.into_iter().enumerate() {
            // four axes meet each body, and each angle four or five times in all
            let angle = angles[(4 * i + k) % angles.len()];
            check(&sweep([0.0, 0.5, 0.0], axis, angle, [1.0, -3.0, 0.1]), body, 2).expect("held");
        }
    }
}

/// Lengths along the axis are as large as doubles go, and those that turn so small beside them that their squares, or
/// they themselves, are nearly zero in the units of the body.
#[test]
fn what_turns_may_be_small_beside_the_axis() {
    for along in [1.0, 1e100, f64::MAX] {
        for off in [f64::from_bits(1), 1e-310, 1e-200, 1e-16, 1.0, 7.397452437574471e146] {
            let bodies = [
                body([0.0; 3], &[[0.0, along, 0.0]]),
                body([off, 0.0, 0.0], &[[0.0, along, 0.0], [0.3 * off, 0.0, off], [off, 0.0, 0.0]]),
            ];
            for (body, angle) in bodies.iter().zip([7.0, 1.0]) {
                check(&sweep([0.0, 0.0, off], [0.0, 1.0, 0.0], angle, [0.0; 3]), body, 3).expect("held");
            }
        }
    }
}

fn cube() -> Zonotope<3> {
    Zonotope::new([0.0; 3], named::cube()).expect("finite")
}

#[test]
fn a_translation_alone_is_exact() {
    let cube = cube();
    for method in Method::ALL {
        let moved = method.volume(&sweep([0.0; 3], [1.0; 3], 0.0, [10.0, 0.0, 0.0]), &cube).expect("in range");
        let generators = [cube.generators(), &[[5.0, 0.0, 0.0]]].concat();
        assert_eq!((moved.center(), moved.generators()), ([5.0, 0.0, 0.0], &generators[..]), "{}", method.id());
    }
}

#[test]
fn the_theorem_adds_three_generators() {
    let volume = Method::default()
        .volume(&sweep([0.0; 3], [0.0, 0.0, 7.0], PI / 2.0, [0.0, 0.0, 4.0]), &cube())
        .expect("in range");
    assert_eq!((volume.center(), volume.generators().len()), ([0.0, 0.0, 2.0], 6));
    assert_eq!(volume.generators()[3], [0.0, 0.0, 2.0]);
    // r = √2 and 2 sin 45° = √2: the radius is 2
    let radius: Vec<f64> = volume.generators()[4..].iter().map(euclidean_norm).collect();
    assert!(radius.iter().all(|r| (2.0..2.0 + 1e-13).contains(r)), "{radius:?}");
}

#[test]
fn no_turn_beyond_half_a_turn_needs_more_than_the_diameter() {
    let point = body([1.0, 0.0, 0.0], &[]);
    let length = |method: Method, angle: f64| {
        method.volume(&sweep([0.0; 3], [0.0, 0.0, 1.0], angle, [0.0; 3]), &point).expect("in range").total_length()
    };
    assert!((length(Method::ByFarthestVertex, 3.2) - 4.0).abs() < 1e-12);
    assert!((length(Method::ByFarthestVertex, 100.0) - 4.0).abs() < 1e-12);
    // from the middle placement half a turn reaches √2 as far as the radius
    assert!((length(Method::ByMiddlePlacement, PI) - 8f64.sqrt()).abs() < 1e-12);
}

#[test]
fn what_is_no_sweep_is_refused() {
    let new = |axis, angle| Sweep::new([0.0; 3], axis, angle, [0.0; 3]);
    assert_eq!(new([0.0, -0.0, 0.0], 1.0), Err(SweepError::ZeroAxis));
    assert_eq!(new([1.0, 0.0, 0.0], -1.0), Err(SweepError::NegativeAngle(-1.0)));
    assert!(matches!(new([f64::NAN, 0.0, 0.0], 1.0), Err(SweepError::NonFinite(_))));
    assert!(matches!(new([1.0, 0.0, 0.0], f64::INFINITY), Err(SweepError::NonFinite(_))));
    let huge = body([f64::MAX; 3], &[[f64::MAX; 3]]);
    for method in Method::ALL {
        assert_eq!(method.volume(&new([1.0, 0.0, 0.0], 3.0).expect("a sweep"), &huge), Err(SweepError::OutOfRange));
    }
}

#[test]
fn motions_are_held_at_every_time() {
    let bar = body([2.0, 0.5, 0.0], &[[1.0, 0.0, 0.0], [0.0, 0.1, 0.3]]);
    let identity = [1.0, 0.0, 0.0, 0.0];
    let piece =
        |until, to, translation| MotionPiece { until, from: identity, to, axis_point: [1.0, 0.0, 0.5], translation };
    let key = |time, quaternion, translation| KeyPose { time, quaternion, translation };
    let motions = [
        Motion::rest(),
        Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], -2.0, [1.0, 0.0, 0.0]).expect("a motion"),
        Motion::from_pieces(&[
            piece(0.25, [1.0, 1.0, 0.0, 0.5], [0.0, 1.0, 0.0]),
            piece(1.0, [0.0, 0.0, 1.0, 0.0], [3.0, 0.0, 0.0]),
        ])
        .expect("a motion"),
        // between these times there is no double: the part is half a turn in no time
        Motion::from_pieces(&[
            piece(0.5, identity, [0.0; 3]),
            piece(0.5_f64.next_up(), [0.0, 0.0, 0.0, 1.0], [0.0; 3]),
            piece(1.0, identity, [0.0, 1.0, 0.0]),
        ])
        .expect("a motion"),
        Motion::from_pieces(&[
            piece(f64::from_bits(1), [0.0, 1.0, 0.0, 0.0], [0.0; 3]),
            piece(1.0, identity, [0.0; 3]),
        ])
        .expect("a motion"),
        Motion::through(&[
            key(0.0, [0.3, 0.1, 0.9, -0.2], [5.0, 0.0, 0.0]),
            key(0.7, [-0.1, 0.8, 0.3, 0.5], [1.0, 2.0, 0.0]),
            key(1.0, identity, [0.0; 3]),
        ])
        .expect("a motion"),
    ];
    for (index, motion) in motions.iter().enumerate() {
        let volume = bar.swept(motion).expect("in range");
        for time in 0..=32 {
            let pose = motion.pose_at(f64::from(time) / 32.0).expect("in range");
            let placed = image(&bar, &pose);
            // a pose is rounded: by less than 1e-13 here
            for sign in 0..8 {
                let u = [1, 2, 4].map(|bit| if sign & bit == 0 { 1.0 } else { -0.6 });
                let reach = placed.support(u).value();
                assert!(reach <= volume.support(u).value() + 1e-13, "{index} {time}");
            }
        }
    }
    assert_eq!(bar.swept(&motions[0]).expect("in range"), bar);
}

#[test]
fn intervals_cover_the_sweep_and_shrink() {
    let bar = body([2.0, 0.5, 0.0], &[[1.0, 0.0, 0.0], [0.0, 0.1, 0.3]]);
    let whole = sweep([0.0; 3], [1.0, 0.0, 2.0], 3.0, [0.0, 1.0, 0.0]);
    for method in [Method::ByFarthestVertex, Method::ByMiddlePlacement, Method::ByTurnedGenerators] {
        let mut last = f64::INFINITY;
        for count in [1, 2, 4, 8] {
            let volumes = volumes_of_intervals(&whole, &bar, count, method).expect("in range");
            for t in turns(&whole, 11) {
                assert!(volumes.iter().any(|volume| holds_placement(volume, &whole, &bar, t, 0.5)), "{count} {t}");
            }
            let longest = volumes.iter().map(Zonotope::total_length).fold(0.0, f64::max);
            assert!(longest < last, "{count}: {longest} after {last}");
            last = longest;
        }
    }
}

/// The mean over directions of how far a volume reaches beyond the sweep, in terms of how far the sweep reaches.
fn excess(method: Method, sweep: &Sweep, body: &Zonotope<3>) -> f64 {
    let volume = method.volume(sweep, body).expect("in range");
    let middle = volume.center();
    let placements: Vec<Zonotope<3>> = (0..=128)
        .map(|i| {
            let motion = Motion::constant_rate(sweep.axis_point, sweep.axis, sweep.angle, [0.0; 3]).expect("a motion");
            image(body, &motion.pose_at(f64::from(i) / 128.0).expect("in range"))
        })
        .collect();
    let directions = named::polar_zonohedron(31, 0.7);
    let (mut beyond, mut whole) = (0.0, 0.0);
    for u in directions.iter().flat_map(|u| [*u, u.map(|c| -c)]) {
        let from_middle = |height: f64| height - crate::numeric::linear::dot(&u, &middle);
        let reach = placements.iter().map(|placed| placed.support(u).value()).fold(f64::NEG_INFINITY, f64::max)
            + crate::numeric::linear::dot(&u, &sweep.translation).max(0.0);
        whole += from_middle(reach);
        beyond += volume.support(u).value() - reach;
        assert!(volume.support(u).value() >= reach - 1e-12, "{}", method.id());
    }
    beyond / whole
}

/// The mean excess in per cent by method, at 15°, 45°, 90° and 180°: a box that turns about its middle, and one on an
/// arm of twice its length.
#[test]
fn excess_over_the_sampled_sweep() {
    let generators = [[1.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.25]];
    let mut table = Vec::new();
    for center in [[0.0; 3], [2.0, 0.0, 0.0]] {
        for method in Method::ALL {
            let row = [15.0, 45.0, 90.0, 180.0].map(|degrees: f64| {
                let sweep = sweep([0.0; 3], [0.0, 0.0, 1.0], degrees.to_radians(), [0.0, 0.0, 1.0]);
                (1000.0 * excess(method, &sweep, &body(center, &generators))).round() / 10.0
            });
            table.push((method.id(), row));
        }
    }
    assert_eq!(table, EXCESS);
}

const EXCESS: [(&str, [f64; 4]); 12] = [
    ("by_farthest_vertex", [20.7, 60.5, 113.1, 163.3]),
    ("by_middle_placement", [8.7, 27.1, 56.7, 112.6]),
    ("by_least_rectangle", [12.8, 38.1, 74.7, 128.3]),
    ("by_least_zonogon", [12.8, 38.1, 72.9, 112.8]),
    ("by_shadow", [5.2, 19.8, 48.6, 106.3]),
    ("by_turned_generators", [4.6, 15.3, 31.5, 48.2]),
    ("by_farthest_vertex", [51.2, 125.5, 187.5, 191.8]),
    ("by_middle_placement", [20.6, 51.8, 83.7, 120.0]),
    ("by_least_rectangle", [10.0, 25.9, 43.2, 54.8]),
    ("by_least_zonogon", [10.0, 23.8, 36.5, 45.0]),
    ("by_shadow", [8.6, 27.0, 53.3, 87.8]),
    ("by_turned_generators", [7.8, 20.8, 34.0, 37.4]),
];

fn vector(size: f64) -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![
        [-size..size, -size..size, -size..size],
        [-3i8..4, -3i8..4, -3i8..4].prop_map(move |v| v.map(|c| f64::from(c) * size / 4.0)),
    ]
}

fn any_body() -> impl Strategy<Value = Zonotope<3>> {
    (vector(3.0), proptest::collection::vec(vector(1.0), 0..5), -1000i32..900).prop_map(
        |(center, generators, exponent)| {
            let scaled =
                |v: [f64; 3]| v.map(|c| crate::numeric::scaling::scale_by_power_of_two(c, i64::from(exponent)));
            Zonotope::new(scaled(center), generators.into_iter().map(scaled).collect()).expect("finite")
        },
    )
}

properties! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn every_placement_is_held(
        body in any_body(),
        point in vector(3.0),
        axis in vector(1.0),
        angle in prop_oneof![0.0..7.0f64, 0.0..1e-6f64, 0.0..40.0f64],
        translation in vector(2.0),
        is_scaled in any::<bool>(),
    ) {
        prop_assume!(axis != [0.0; 3]);
        let size = if is_scaled { body.center()[0].abs() } else { 1.0 };
        let scaled = |v: [f64; 3]| v.map(|c| c * size);
        check(&sweep(scaled(point), axis, angle, scaled(translation)), &body, 2)?;
    }

    #[test]
    fn the_farthest_vertex_is_bounded_closely(body in any_body(), point in vector(3.0), axis in vector(1.0)) {
        prop_assume!(axis != [0.0; 3]);
        let sweep = sweep(point, axis, 1.0, [0.0; 3]);
        let scaled = ScaledBody::of(&body, point);
        let bound = Shadow::of(&Plane::orthogonal_to(axis), &scaled, &mut ()).farthest_above(&mut ());
        let bound = Dyadic::from_f64(bound).scaled(scaled.exponent).to_rational();
        let exact = farthest_squared(&sweep, &body);
        prop_assert!(exact <= &bound * &bound);
        let size = Dyadic::one().scaled(scaled.exponent - 40).to_rational();
        let below = bound - size;
        prop_assert!(below < crate::numeric::Rational::ZERO || &below * &below <= exact);
    }
}
