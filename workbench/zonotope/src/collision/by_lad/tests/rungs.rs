//! Every rung of the ladder is reached by a named family of generators: one that nothing reaches would be dead code.

use crate::collision::by_lad::{gauge, locate};
use crate::collision::{Location, Query};
use crate::numeric::linear::{cross, dot};
use crate::tally::{OperationCounts, Rung};
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The family, and the number of generators, that reaches a rung.
const REACHED_BY: [(Rung, &str, usize); Rung::ALL.len()] = [
    (Rung::LeastSquares, "random", 12),
    (Rung::LeastSquaresInPlane, "in a plane", 12),
    (Rung::SampledDirection, "random", 1200),
    (Rung::StratifiedPass, "random", 1200),
    (Rung::ClippedCoefficients, "random", 12),
    (Rung::ZeroDisplacement, "random", 12),
    (Rung::BestPair, "random", 12),
    (Rung::AllInDoubles, "random", 40),
    (Rung::ParallelClasses, "noisy directions", 400),
    (Rung::SeparatingGuess, "wide scales", 400),
    (Rung::SampledCell, "random", 400),
    (Rung::WiderCell, "near a plane", 400),
    (Rung::CorrectedSample, "noisy directions", 400),
    (Rung::CuttingPlanes, "heavy tails", 400),
    (Rung::ExactVertex, "random", 12),
    (Rung::FlatBody, "in a plane", 400),
    (Rung::ExactInCells, "lattice", 400),
    (Rung::LongestFirst, "all scales", 400),
    (Rung::ExactWhole, "wide scales", 40),
    (Rung::RoundedDirection, "random", 12),
    (Rung::DirectionOfDoubles, "random", 12),
    (Rung::RationalDirection, "concurrent", 12),
    (Rung::RoundedCoefficients, "random", 12),
    (Rung::WellSpreadBasis, "small beside a lattice", 40),
    (Rung::ScaledSigns, "random", 12),
    (Rung::PivotedCoefficients, "lattice", 1200),
];

/// At most this many questions are asked before a rung counts as unreached.
const QUESTION_LIMIT: usize = 3000;

fn body(family: &str, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
    let directions: Vec<[f64; 3]> = (0..8).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0))).collect();
    let mut generator = |i: usize| {
        let v = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
        let mut digit = |most: i32| f64::from(random.random_range(-most..=most));
        match family {
            "random" => v,
            "lattice" => [digit(3), digit(3), digit(3)],
            "noisy directions" => [0, 1, 2].map(|k| directions[i % 8][k] + 1e-9 * v[k]),
            "near a plane" if i.is_multiple_of(10) => v,
            "near a plane" => [v[0], v[1], v[0] + 1e-6 * v[2]],
            "in a plane" => [v[0], v[1], 0.0].map(|c| (1024.0 * c).round()),
            "wide scales" => v.map(|c| c * libm::exp2(digit(200))),
            "all scales" => v.map(|c| c * libm::exp2(digit(600))),
            "heavy tails" => v.map(|c| c * libm::pow(random.random_range(1e-6..1.0), -0.8)),
            "concurrent" => [v[0], v[1], v[0] + v[1] + 1e-14 * v[2]],
            "small beside a lattice" if i.is_multiple_of(2) => [digit(1), digit(1), digit(1)],
            "small beside a lattice" => v.map(|c| 1e-12 * c),
            _ => panic!("no family is called {family}"),
        }
    };
    (0..n).map(&mut generator).collect()
}

/// A point of the boundary: a vertex, a point of a facet, or where the ray along a random direction leaves.
fn boundary_point(body: &[[f64; 3]], number: usize, random: &mut Pcg64Mcg) -> [f64; 3] {
    let direction = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
    let pair = [0, 1].map(|_| body[random.random_range(0..body.len())]);
    let sum = |u: [f64; 3], share_of_pair: Option<f64>| {
        body.iter().fold([0.0; 3], |sum, v| {
            let sign = f64::copysign(1.0, dot(v, &u));
            let part = share_of_pair.filter(|_| pair.contains(v)).unwrap_or(sign);
            [0, 1, 2].map(|k| sum[k] + part * v[k])
        })
    };
    match number % 3 {
        0 => sum(direction, None),
        1 => sum(cross(&pair[0], &pair[1]), Some(0.25)),
        _ => {
            let query = Query::new([0.0; 3], direction, body).expect("finite");
            let gauge = crate::collision::by_lad::gauge(&query, &mut ()).value;
            if gauge > 0.0 && gauge < f64::MAX { direction.map(|c| c / gauge) } else { direction }
        }
    }
}

/// The place of a question's point along the ray to a point of the boundary.
const REACHES: [f64; 12] = [
    1.0,
    1.0 + 1e-9,
    1.0 - 1e-9,
    1.0 + 4.0 * f64::EPSILON,
    1.0 - 4.0 * f64::EPSILON,
    0.3,
    3.0,
    1.0 + 1e-3,
    0.97,
    0.85,
    0.0,
    1.0 - 1e-12,
];

#[test]
fn each_rung_is_reached_by_its_family() {
    assert_eq!(REACHED_BY.map(|(rung, ..)| rung), Rung::ALL);
    let mut unreached = Vec::new();
    for (rung, family, n) in REACHED_BY {
        let random = &mut Pcg64Mcg::seed_from_u64(n as u64);
        let is_reached = (0..QUESTION_LIMIT).any(|number| {
            let body = body(family, n, random);
            let reach = REACHES[number / 3 % REACHES.len()];
            let p = boundary_point(&body, number, random).map(|c| reach * c);
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let mut counts = OperationCounts::default();
            let location: Location<3> = locate(&query, &mut counts);
            let gauge = gauge(&query, &mut counts);
            assert_eq!(location.status(), gauge.location.status(), "{family}, {n} generators, {number}");
            counts.answers_of(rung) > 0
        });
        if !is_reached {
            unreached.push((rung, family, n));
        }
    }
    assert!(unreached.is_empty(), "{unreached:?}");
}

/// The early rungs that bodies under poses reach, and the number of generators of two random bodies that do.
///
/// The rung of bodies in a plane through few axes is not among them: such a plane is recognised by its rows, which
/// stand in two frames here.
const REACHED_BY_POSED: [(Rung, usize); 4] = [
    (Rung::LeastSquares, 12),
    (Rung::SampledDirection, 1200),
    (Rung::StratifiedPass, 1200),
    (Rung::ClippedCoefficients, 12),
];

#[test]
fn early_rungs_are_reached_by_posed_bodies() {
    for (rung, n) in REACHED_BY_POSED {
        let random = &mut Pcg64Mcg::seed_from_u64(n as u64);
        let is_reached = (0..QUESTION_LIMIT).any(|number| {
            let mut half = || Zonotope::new([0.0; 3], body("random", n / 2, random)).expect("finite");
            let (a, b) = (half(), half());
            let mut numbers = || [0, 1, 2, 3].map(|_| random.random_range(-1.0..1.0));
            let [from, turn] = [numbers(), numbers()];
            let from = Pose::from_quaternion(from, [0.0; 3]).expect("a quaternion");
            let reach = 0.05 * n as f64 * f64::from(number as u32 % 20);
            let to = Pose::from_quaternion(turn, [reach, 0.0, 0.0]).expect("a quaternion");
            let mut counts = OperationCounts::default();
            let query = Query::of_placed(a.at(&from), b.at(&to));
            assert_eq!(locate(&query, &mut counts), locate(&query, &mut ()));
            counts.answers_of(rung) > 0
        });
        assert!(is_reached, "{rung:?}, {n} generators");
    }
}
