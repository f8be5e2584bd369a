use proptest::prelude::*;

use super::*;
use crate::hull::convex_hull;
use crate::hull::tests::point_sets;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn rotating_calipers_agree_with_brute_force(points in point_sets()) {
        let hull = convex_hull(&points).expect("the points are finite");
        prop_assert_eq!(by_rotating_calipers::farthest_vertices(&hull), brute_force::farthest_vertices(&hull));
    }
}

fn answers(points: &[[f64; 2]]) -> Vec<(usize, bool)> {
    let hull = convex_hull(points).expect("the points are finite");
    farthest_vertices(&hull).into_iter().map(|answer| (answer.vertex().get(), answer.is_tied())).collect()
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

#[test]
fn the_number_of_cross_products_is_linear() {
    let points: Vec<[f64; 2]> = (0..1000).map(|k| f64::from(k) - 500.0).map(|x| [x, x * x]).collect();
    let hull = convex_hull(&points).expect("the points are finite");
    let mut counts = crate::tally::OperationCounts::default();
    farthest_vertices_counted(&hull, &mut counts);
    assert!(counts.get(crate::tally::Operation::Turn) <= 1000 + 34 * 11);
}
