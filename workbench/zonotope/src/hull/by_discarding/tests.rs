//! Inputs large enough for discarding and for buckets; [`hull::tests`](crate::hull) has the small ones.

use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::hull::{VertexIndex, by_monotone_chain};
use crate::interop::verifier::check_convex_hull;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::OperationCounts;

/// A point for two numbers in [0, 1).
type Shape = fn(f64, f64) -> [f64; 2];

const SHAPES: [(&str, Shape); 12] = [
    ("square", |s, t| [s, t]),
    ("far from the origin", |s, t| [1e9 + s, 1e9 - t]),
    ("lattice", |s, t| [(s * 60.0).floor(), (t * 60.0).floor()]),
    ("circle", |s, _| circle(s)),
    ("thin ellipse", |s, _| [circle(s)[0], circle(s)[1] * 1e-9]),
    ("steep ellipse", |s, _| [circle(s)[0] * 1e-9, circle(s)[1]]),
    ("disc", |s, t| circle(s).map(|value| value * t.sqrt())),
    ("annulus", |s, t| circle(s).map(|value| value * (1.0 - 1e-12 * t))),
    ("exponential abscissas", |s, t| [libm::exp2(s * 2000.0 - 1000.0), t]),
    ("diagonal", |s, t| [s, s + t * f64::EPSILON]),
    ("few abscissas", |s, t| [(s * 3.0).floor(), t]),
    ("vertical", |_, t| [0.1, t]),
];

fn circle(turn: f64) -> [f64; 2] {
    let angle = turn * std::f64::consts::TAU;
    [libm::cos(angle), libm::sin(angle)]
}

fn instance(shape: Shape, count: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    (0..count).map(|_| shape(random.random(), random.random())).collect()
}

#[test]
fn large_instances_agree_and_verify() {
    for (name, shape) in SHAPES {
        for count in [1000, FINER_COLUMNS_FROM + 77] {
            let points = instance(shape, count, 5);
            let hull = convex_hull(&points, &mut ()).expect("the points are finite");
            assert_eq!(check_convex_hull(&points, &hull).proof().map(drop), Ok(()), "{name}, {count} points");
            assert_eq!(by_monotone_chain::convex_hull(&points, &mut ()).as_ref(), Ok(&hull), "{name}, {count} points");
        }
    }
}

properties! {
    #![proptest_config(crate::property_cases::config(150))]

    #[test]
    fn instances_with_duplicates_agree_at_every_scale(
        shape in 0..SHAPES.len(),
        count in 65_usize..3000,
        seed in any::<u64>(),
        exponents in [-1000_i64..=1000, -1000_i64..=1000],
        repeated in 1_usize..4,
    ) {
        let base = instance(SHAPES[shape].1, count, seed);
        let scaled = base.iter().map(|point| [0, 1].map(|axis| scale_by_power_of_two(point[axis], exponents[axis])));
        let points: Vec<[f64; 2]> =
            scaled.filter(|point| point.iter().all(|value| value.is_finite())).collect::<Vec<_>>().repeat(repeated);
        prop_assume!(!points.is_empty());
        let hull = convex_hull(&points, &mut ()).expect("the points are finite");
        prop_assert_eq!(check_convex_hull(&points, &hull).proof().map(drop), Ok(()));
        prop_assert_eq!(by_monotone_chain::convex_hull(&points, &mut ()), Ok(hull));
    }
}

/// Points in the box that are closest to the chains of the polygon are the ones at risk.
#[test]
fn only_points_inside_are_discarded() {
    for (name, shape) in SHAPES {
        let points = instance(shape, 3000, 11);
        let polygon = by_monotone_chain::convex_hull(&points[..300], &mut ()).expect("the points are finite");
        let mut probes = points.clone();
        for at in 0..polygon.edge_count() {
            let [from, to] = polygon.edge(VertexIndex::new(at));
            probes.extend((0..20).map(|k| {
                let along = f64::from(k) / 19.0;
                [0, 1].map(|axis| from[axis] + along * (to[axis] - from[axis]))
            }));
        }
        let bounds = Bounds::of(&probes).expect("the probes are finite");
        let interior = Columns::new(&bounds, 256).and_then(|columns| Interior::<256>::new(&polygon, columns, &bounds));
        let Some(interior) = interior else { continue };
        let outside = interior.points_outside(&probes);
        let discarded: Vec<[f64; 2]> = (0..probes.len() as u32)
            .filter(|at| outside.binary_search(at).is_err())
            .map(|at| probes[at as usize])
            .collect();
        let with_discarded = [polygon.vertices(), &discarded].concat();
        let hull = by_monotone_chain::convex_hull(&with_discarded, &mut ()).expect("the points are finite");
        assert_eq!(hull.vertices(), polygon.vertices(), "{name}");
    }
}

#[test]
fn most_points_of_a_disc_are_discarded() {
    let points = instance(|s, t| circle(s).map(|value| value * t.sqrt()), 100_000, 3);
    let mut counts = OperationCounts::default();
    convex_hull(&points, &mut counts).expect("the points are finite");
    assert!(counts.get(Operation::Turn) < 20_000, "{counts:?}");
    assert!(counts.get(Operation::PointRead) < 250_000, "{counts:?}");
}

#[test]
fn a_circle_takes_four_passes() {
    let points = instance(|s, _| circle(s), 100_000, 3);
    let mut counts = OperationCounts::default();
    convex_hull(&points, &mut counts).expect("the points are finite");
    assert_eq!(counts.get(Operation::PointRead), 400_000);
}
