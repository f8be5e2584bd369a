//! No collision of fast and of crafted motions is missed: dense sampling never sees a contact that the answer does not
//! know, and the gap of each stretch is positive at exact times.

use super::{exact_gap_at, random_body, random_parts};
use crate::motion::continuous::{FirstContact, Method, first_contact};
use crate::motion::{Motion, MotionPiece};
use crate::numeric::Rational;
use crate::zonotope::Zonotope;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::BTreeMap;

/// Samples of a motion.
const SAMPLES: u32 = 96;

/// The number of motions that a run draws, of those that a long one draws.
fn cases(long_run: u32) -> u32 {
    crate::property_cases::config(long_run).cases
}

/// Checks an answer against samples.
fn check_by_sampling(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2], found: &FirstContact) {
    let end = found.free().last().map_or(0.0, |stretch| stretch.until);
    let follow = found.free().windows(2).all(|pair| pair[0].until == pair[1].from);
    assert!(follow && found.free().first().is_none_or(|first| first.from == 0.0), "stretches follow each other");
    match found {
        FirstContact::Separate { .. } => assert_eq!(end, 1.0),
        FirstContact::Contact { time, .. } => {
            assert!(end == time[0] && (time[1] - time[0] <= 2f64.powi(-30)), "{time:?} after {end}");
            let [p, q] = motions.map(|motion| motion.pose_at(time[1]).expect("finite"));
            assert!(bodies[0].at(&p).distance(bodies[1].at(&q)) < 1e-11);
        }
        FirstContact::Grazing { time, distance_at_most, .. } => {
            assert!(end == time[0] && *distance_at_most < 1e-6, "{time:?} {distance_at_most}");
        }
    }
    for i in 0..=SAMPLES {
        let time = f64::from(i) / f64::from(SAMPLES);
        if time >= end && !matches!(found, FirstContact::Separate { .. }) {
            break;
        }
        let [p, q] = motions.map(|motion| motion.pose_at(time).expect("finite"));
        let (a, b) = (bodies[0].at(&p), bodies[1].at(&q));
        // bodies that are proved to be disjoint may touch as they are rounded, and no more
        let is_deep = a.intersects(b) && a.penetration(b).lower > 1e-9;
        assert!(!is_deep, "a contact at {time} of {motions:?} {bodies:?}, free until {end}");
    }
}

/// Checks the gap of each stretch of a rational motion at exact times.
fn check_gaps(bodies: [&Zonotope<3>; 2], parts: [&[MotionPiece]; 2], found: &FirstContact) {
    for stretch in found.free() {
        for eighths in [0u8, 3, 5, 8] {
            let gap = exact_gap_at(bodies, parts, stretch, eighths);
            assert!(gap > Rational::ZERO, "{stretch:?}");
        }
    }
}

fn unit(rng: &mut Pcg64) -> [f64; 3] {
    loop {
        let v = [0, 1, 2].map(|_| rng.random_range(-1.0..1.0));
        let square: f64 = v.iter().map(|c| c * c).sum();
        if (0.01..1.0).contains(&square) {
            return v.map(|c| c / square.sqrt());
        }
    }
}

#[test]
fn random_fast_motions_at_constant_rate_miss_no_collision() {
    let mut rng = Pcg64::seed_from_u64(1);
    let mut counts = BTreeMap::new();
    for _ in 0..cases(8000) {
        let sizes = [rng.random_range(1..7), rng.random_range(3..7)];
        let bodies = sizes.map(|n| random_body(&mut rng, n, 0.8));
        let motions = [0, 1].map(|_| {
            let angle = rng.random_range(-12.0..12.0);
            let (point, gone) = (unit(&mut rng), unit(&mut rng).map(|c| 4.0 * c));
            Motion::constant_rate(point, unit(&mut rng), angle, gone).expect("an axis")
        });
        let apart = unit(&mut rng).map(|c| 2.5 * c);
        let moved = bodies[1].translated(apart).expect("finite");
        let found = first_contact([&bodies[0], &moved], motions.each_ref());
        check_by_sampling([&bodies[0], &moved], motions.each_ref(), &found);
        *counts.entry(found.name()).or_insert(0u32) += 1;
    }
    let undecided = counts.get("grazing").copied().unwrap_or(0);
    assert!(1000 * undecided <= counts.values().sum() && counts["contact"] > 100, "{counts:?}");
}

#[test]
fn random_fast_rational_motions_miss_no_collision() {
    let mut rng = Pcg64::seed_from_u64(2);
    let mut counts = BTreeMap::new();
    for case in 0..cases(8000) {
        let sizes = [rng.random_range(1..7), rng.random_range(3..7)];
        let [a, b] = sizes.map(|n| random_body(&mut rng, n, 0.8));
        let b = b.translated(unit(&mut rng).map(|c| 2.5 * c)).expect("finite");
        let parts = [0, 1].map(|_| {
            let count = rng.random_range(1..4);
            random_parts(&mut rng, count)
        });
        let motions = parts.each_ref().map(|parts| Motion::from_pieces(parts).expect("a motion"));
        let found = first_contact([&a, &b], motions.each_ref());
        check_by_sampling([&a, &b], motions.each_ref(), &found);
        if case % 16 == 0 {
            check_gaps([&a, &b], [&parts[0], &parts[1]], &found);
        }
        *counts.entry(found.name()).or_insert(0u32) += 1;
    }
    let undecided = counts.get("grazing").copied().unwrap_or(0);
    assert!(1000 * undecided <= counts.values().sum() && counts["contact"] > 100, "{counts:?}");
}

/// A body of a kind: a box, a long thin bar, a flat plate, a segment, a point.
fn crafted_body(rng: &mut Pcg64) -> Zonotope<3> {
    let halves = match rng.random_range(0..5) {
        0 => vec![[0.5, 0.0, 0.0], [0.0, 0.25, 0.0], [0.0, 0.0, 0.25]],
        1 => vec![[2.0, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]],
        2 => vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        3 => vec![[0.0, 1.5, 0.0]],
        _ => vec![],
    };
    Zonotope::new([0.0; 3], halves).expect("finite")
}

#[test]
fn crafted_motions_miss_no_collision() {
    let mut rng = Pcg64::seed_from_u64(3);
    let mut counts = BTreeMap::new();
    let turn = std::f64::consts::TAU;
    for _ in 0..cases(40_000) {
        let (a, b) = (crafted_body(&mut rng), crafted_body(&mut rng));
        // far away, through the body, or at its end
        let point = [[0.0; 3], [1.0, 0.0, 0.0], [100.0, 0.0, 0.0], [0.5, 0.25, 0.0]][rng.random_range(0..4)];
        let axis = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 0.0]][rng.random_range(0..4)];
        let angle = [turn / 2.0, turn, 3.0 * turn, -5.5 * turn, turn / 4.0, 0.0][rng.random_range(0..6)];
        let gone = [[0.0; 3], [0.0, 0.0, 2.0], [-3.0, 0.0, 0.0]][rng.random_range(0..3)];
        let motion = Motion::constant_rate(point, axis, angle, gone).expect("an axis");
        let graze = [0.0, 1e-9, -1e-9, 1e-12, -1e-6][rng.random_range(0..5)];
        let away = [0.5, 1.0, 1.5, 2.0, 0.75][rng.random_range(0..5)] + graze;
        let side = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.8, 0.0]][rng.random_range(0..4)];
        let b = b.translated(side.map(|c| away * c)).expect("finite");
        let rest = Motion::rest();
        let found = first_contact([&a, &b], [&motion, &rest]);
        check_by_sampling([&a, &b], [&motion, &rest], &found);
        *counts.entry(found.name()).or_insert(0u32) += 1;
    }
    assert!(counts["separate"] > 100 && counts["contact"] > 100, "{counts:?}");
}

#[test]
fn methods_find_the_same_case() {
    let mut rng = Pcg64::seed_from_u64(4);
    for _ in 0..cases(400) {
        let [a, b] = [4, 5].map(|n| random_body(&mut rng, n, 0.8));
        let b = b.translated(unit(&mut rng).map(|c| 2.5 * c)).expect("finite");
        let parts = [0, 1].map(|_| random_parts(&mut rng, 1));
        let motions = parts.each_ref().map(|parts| Motion::from_pieces(parts).expect("a motion"));
        let (bodies, motions) = ([&a, &b], motions.each_ref());
        let default = first_contact(bodies, motions);
        for method in Method::ALL {
            let found = method.first_contact(bodies, motions, 2f64.powi(-12), &mut ());
            check_gaps(bodies, [&parts[0], &parts[1]], &found);
            let met = |found: &FirstContact| match found {
                FirstContact::Contact { time, .. } => Some(time[1]),
                _ => None,
            };
            match (met(&default), met(&found)) {
                (Some(s), Some(t)) => assert!((s - t).abs() <= 2f64.powi(-12), "{method:?} {s} {t}"),
                (s, t) => assert!(s == t || found.name() == "grazing" || default.name() == "grazing", "{method:?}"),
            }
        }
    }
}
