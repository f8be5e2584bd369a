//! First contacts against dense sampling, and their proofs against exact gaps at rational times.

use super::brute_force::{Placement, gap};
use super::by_control_points::{DEFAULT_RESOLUTION, first_contact_counted};
use super::{FirstContact, FreeStretch, SeparatingDirection, first_contact};
use crate::motion::{Motion, MotionPiece};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::tally::{Operation, OperationCounts};
use crate::zonotope::Zonotope;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

mod any_size;
mod degenerate;
mod soundness;
mod turning_directions;

/// A body of random generators of about a size.
pub(super) fn random_body(rng: &mut Pcg64, generators: usize, size: f64) -> Zonotope<3> {
    let vector = |rng: &mut Pcg64, size: f64| [0, 1, 2].map(|_| size * rng.random_range(-1.0..1.0));
    let center = vector(rng, 0.5);
    let list = (0..generators).map(|_| vector(rng, size / (generators as f64).sqrt())).collect();
    Zonotope::new(center, list).expect("finite")
}

/// Parts with quaternions of small integers, each at most half a turn.
pub(super) fn random_parts(rng: &mut Pcg64, parts: usize) -> Vec<MotionPiece> {
    let quaternion = |rng: &mut Pcg64| loop {
        let q = [0, 1, 2, 3].map(|_| f64::from(rng.random_range(-4i8..=4)));
        if q != [0.0; 4] {
            return q;
        }
    };
    let vector = |rng: &mut Pcg64, size: f64| [0, 1, 2].map(|_| size * rng.random_range(-1.0..1.0));
    (0..parts)
        .map(|part| {
            let from = quaternion(rng);
            let to = quaternion(rng);
            let sign = if (0..4).map(|k| from[k] * to[k]).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
            let until = (part + 1) as f64 / parts as f64;
            MotionPiece {
                until,
                from,
                to: to.map(|c| sign * c),
                axis_point: vector(rng, 1.0),
                translation: vector(rng, 4.0),
            }
        })
        .collect()
}

/// The gap of a stretch after some eighths of its time, exactly.
fn exact_gap_at(bodies: [&Zonotope<3>; 2], parts: [&[MotionPiece]; 2], stretch: &FreeStretch, eighths: u8) -> Rational {
    let share = Rational::from(eighths) / Rational::from(8u8);
    let exact = |t: f64| Dyadic::from_f64(t).to_rational();
    let time = exact(stretch.from) + share * (exact(stretch.until) - exact(stretch.from));
    let middle = stretch.from + (stretch.until - stretch.from) / 2.0;
    let part = |parts: &[MotionPiece]| parts.iter().position(|part| middle < part.until).expect("a part");
    let placements = parts.map(|parts| Placement::at(parts, part(parts), &time));
    gap(bodies, placements.each_ref(), &stretch.direction)
}

fn check(bodies: [&Zonotope<3>; 2], parts: [&[MotionPiece]; 2]) -> &'static str {
    let motions = parts.map(|parts| Motion::from_pieces(parts).expect("the parts are a motion"));
    let found = first_contact(bodies, motions.each_ref());
    let mut end = 0.0;
    for stretch in found.free() {
        assert_eq!(stretch.from, end, "stretches follow each other");
        end = stretch.until;
        for eighths in [0u8, 1, 3, 5, 7, 8] {
            assert!(exact_gap_at(bodies, parts, stretch, eighths) > Rational::ZERO, "{stretch:?}");
        }
    }
    match &found {
        FirstContact::Separate { .. } => assert_eq!(end, 1.0),
        FirstContact::Contact { time, .. } => {
            assert!(end == time[0] && time[1] - time[0] <= 2f64.powi(-30));
            let [p, q] = motions.each_ref().map(|motion| motion.pose_at(time[1]).expect("finite"));
            let slack = bodies[0].at(&p).distance(bodies[1].at(&q));
            assert!(slack < 1e-12, "{slack}");
        }
        FirstContact::Grazing { time, distance_at_most, .. } => {
            assert!(end == time[0] && *distance_at_most < 1e-6, "{time:?} {distance_at_most}");
        }
    }
    // what sampling sees, the answer sees not later
    let met = (0..=256).map(|i| f64::from(i) / 256.0).find(|&t| {
        let [p, q] = motions.each_ref().map(|motion| motion.pose_at(t).expect("finite"));
        bodies[0].at(&p).intersects(bodies[1].at(&q))
    });
    if let Some(t) = met {
        assert!(end <= t, "sampled contact at {t}, free until {end}");
    }
    found.name()
}

#[test]
fn answers_agree_with_sampling_and_proofs_with_exact_gaps() {
    let mut rng = Pcg64::seed_from_u64(7);
    let mut counts = std::collections::BTreeMap::new();
    for _ in 0..300 {
        let sizes = [rng.random_range(1..8), rng.random_range(1..8)];
        let [a, b] = sizes.map(|n| random_body(&mut rng, n, 0.7));
        let b = b.translated([2.5, 0.0, 0.0]).expect("finite");
        let parts = [0, 1].map(|_| {
            let count = rng.random_range(1..4);
            random_parts(&mut rng, count)
        });
        let name = check([&a, &b], [&parts[0], &parts[1]]);
        *counts.entry(name).or_insert(0) += 1;
    }
    assert!(counts["separate"] > 30 && counts["contact"] > 30, "{counts:?}");
}

#[test]
fn a_link_that_passes_a_box_is_proved_by_few_directions() {
    let link = Zonotope::new([1.0, 0.0, 0.0], vec![[1.0, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]).expect("finite");
    let cube = Zonotope::new([0.0, 3.2, 0.0], vec![[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]]).expect("finite");
    let quarter = Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], std::f64::consts::PI, [0.0; 3]).expect("an axis");
    let found = first_contact([&link, &cube], [&quarter, &Motion::rest()]);
    let FirstContact::Separate { free } = &found else { panic!("{found:?}") };
    assert!(free.len() <= 8, "{free:?}");
    let near = cube.translated([0.0, -0.75, 0.0]).expect("finite");
    let found = first_contact([&link, &near], [&quarter, &Motion::rest()]);
    let FirstContact::Contact { time, .. } = &found else { panic!("{found:?}") };
    assert!(time[0] > 0.25 && time[1] < 0.5);
    let directions = found.free().iter().map(|stretch| &stretch.direction);
    assert!(directions.clone().count() < 100 && directions.clone().any(|d| matches!(d, SeparatingDirection::Space(_))));
}

/// Guesses along directions that stay in space alone would leave the same share of the time each time.
#[test]
fn contacts_of_spinning_bodies_take_few_stretches() {
    let mut rng = Pcg64::seed_from_u64(8);
    let (mut contacts, mut stretches) = (0, 0);
    for _ in 0..400 {
        let [a, b] = [0.0, 3.0].map(|x| random_body(&mut rng, 3, 0.8).translated([x, 0.0, 0.0]).expect("finite"));
        let motions = [2.0, -1.0].map(|travel| {
            let axis = [0, 1, 2].map(|_| rng.random_range(-1.0..1.0));
            Motion::constant_rate(axis, axis, rng.random_range(-8.0..8.0), [travel, 0.0, 0.0]).expect("an axis")
        });
        let mut counts = OperationCounts::default();
        let found = first_contact_counted([&a, &b], motions.each_ref(), DEFAULT_RESOLUTION, &mut counts);
        if found.name() == "contact" && !found.free().is_empty() {
            contacts += 1;
            stretches += counts.get(Operation::Stretch);
        }
    }
    assert!(contacts > 40, "{contacts}");
    assert!(stretches <= 26 * contacts, "{stretches} of {contacts} contacts");
}

#[test]
fn bodies_that_meet_in_a_flat_or_degenerate_way_have_a_proof() {
    let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
    let plate = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
    let point = Zonotope::new([0.0; 3], Vec::new()).expect("finite");
    let away = Motion::translation([9.0, 0.0, 0.0]).expect("finite");
    let turning = Motion::constant_rate([0.0; 3], [1.0, 2.0, 3.0], 2.0, [0.0; 3]).expect("an axis");
    for (a, b, motion) in
        [(&cube, &cube, &away), (&cube, &cube, &turning), (&plate, &plate, &away), (&point, &point, &away)]
    {
        let found = first_contact([a, b], [motion, &Motion::rest()]);
        assert!(matches!(found, FirstContact::Contact { time: [0.0, 0.0], .. }), "{found:?}");
    }
}

#[test]
fn the_basis_of_a_contact_solves_the_exact_system() {
    let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
    let other = cube.translated([5.0, 0.3, 0.1]).expect("finite");
    let parts = [MotionPiece {
        until: 1.0,
        from: [1.0, 0.0, 0.0, 0.0],
        to: [3.0, 1.0, -1.0, 2.0],
        axis_point: [0.1, 0.2, 0.3],
        translation: [5.0, 0.0, 0.0],
    }];
    let motion = Motion::from_pieces(&parts).expect("a motion");
    let found = first_contact([&cube, &other], [&motion, &Motion::rest()]);
    let FirstContact::Contact { time, witness, .. } = &found else { panic!("{found:?}") };
    let exact = |value: f64| crate::numeric::dyadic::Dyadic::from_f64(value).to_rational();
    let placement = Placement::at(&parts, 0, &exact(time[1]));
    let rest = [0, 1, 2].map(|k| {
        let own = (0..3).map(|i| exact(witness.coefficients[i]) * &placement.turned(cube.generators()[i])[k]);
        let others = (0..3).map(|i| exact(witness.coefficients[3 + i]) * exact(other.generators()[i][k]));
        let sum = own.chain(others).fold(Rational::ZERO, |sum, term| sum + term);
        (exact(other.center()[k]) - &placement.of(cube.center())[k] - sum).to_f64().value()
    });
    assert!(rest.iter().all(|c| c.abs() < 1e-15), "{rest:?}");
}
