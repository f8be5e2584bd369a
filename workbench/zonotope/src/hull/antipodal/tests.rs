use proptest::prelude::*;

use super::*;
use crate::hull::convex_hull;
use crate::hull::tests::point_sets;

properties! {
    #![proptest_config(crate::property_cases::config(1500))]

    #[test]
    fn rotating_calipers_agree_with_brute_force(points in point_sets()) {
        let hull = convex_hull(&points, &mut ()).expect("the points are finite");
        let found = by_rotating_calipers::farthest_vertices(&hull, &mut ());
        prop_assert_eq!(found, brute_force::farthest_vertices(&hull, &mut ()));
    }
}

fn answers(points: &[[f64; 2]]) -> Vec<(usize, bool)> {
    let hull = convex_hull(points, &mut ()).expect("the points are finite");
    farthest_vertices(&hull, &mut ()).into_iter().map(|answer| (answer.vertex().get(), answer.is_tied())).collect()
}

#[test]
fn a_point_and_a_segment_have_no_edges() {
    assert_eq!(answers(&[[1.0, 2.0]]), []);
    assert_eq!(answers(&[[1.0, 2.0], [3.0, 4.0], [2.0, 3.0]]), []);
}

#[test]
fn a_triangle_has_the_opposite_vertices() {
    assert_eq!(answers(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), [(2, false), (0, false), (1, false)]);
}

#[test]
fn every_edge_of_a_parallelogram_ties() {
    let parallelogram = [[0.0, 0.0], [2.0, 1.0], [3.0, 4.0], [1.0, 3.0]];
    assert_eq!(answers(&parallelogram), [(2, true), (3, true), (0, true), (1, true)]);
}

#[test]
fn a_tie_is_broken_by_one_unit_in_the_last_place() {
    let top = 1.0 + f64::EPSILON;
    assert_eq!(answers(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, top]])[0], (3, false));
    assert_eq!(answers(&[[0.0, 0.0], [1.0, 0.0], [1.0, top], [0.0, 1.0]])[0], (2, false));
}

/// Enough edges for several merges, with chains of equal and of very different lengths, and with ties at all edges.
#[test]
fn large_hulls_agree_with_brute_force() {
    let angle = |k: i32, count: i32| std::f64::consts::TAU * f64::from(k) / f64::from(count);
    let on_circle = |k, count| [libm::cos(angle(k, count)), libm::sin(angle(k, count))];
    let parabola = |k: i32| [f64::from(k) - 500.0, (f64::from(k) - 500.0) * (f64::from(k) - 500.0)];
    let shapes: [Vec<[f64; 2]>; 5] = [
        (0..999).map(|k| on_circle(k, 999)).collect(),
        (0..1000).map(|k| on_circle(k * k % 1009, 1009)).collect(),
        (0..1000).map(parabola).collect(),
        (0..1000).map(parabola).map(|[x, y]| [-x, -y]).collect(),
        (0..500).map(|k| on_circle(k, 1000)).flat_map(|[x, y]| [[x, y], [-x, -y]]).collect(),
    ];
    for (number, points) in shapes.iter().enumerate() {
        let hull = convex_hull(points, &mut ()).expect("the points are finite");
        assert!(hull.edge_count() > 500, "shape {number}");
        assert_eq!(farthest_vertices(&hull, &mut ()), brute_force::farthest_vertices(&hull, &mut ()), "shape {number}");
    }
}

#[test]
fn the_number_of_cross_products_is_linear() {
    let points: Vec<[f64; 2]> = (0..1000).map(|k| f64::from(k) - 500.0).map(|x| [x, x * x]).collect();
    let hull = convex_hull(&points, &mut ()).expect("the points are finite");
    let mut counts = crate::tally::OperationCounts::default();
    farthest_vertices(&hull, &mut counts);
    assert!(counts.get(crate::tally::Operation::Turn) <= 1000 + 34 * 11);
}
