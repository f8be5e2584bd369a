//! Hulls in space against the truth, on clouds with many points in one plane and numbers of all sizes.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use proptest::prelude::*;

use super::brute_force::facets;
use super::{SolidHull, hull_corners, solid_hull};
use crate::hull::HullError;
use crate::numeric::orientation::in_space::side_of_plane;

/// Every side of a triangle is one of another triangle the other way around, and no point is above a triangle.
fn check_surface(points: &[[f64; 3]], hull: &SolidHull) {
    let sides = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let all: BTreeSet<[usize; 2]> = hull.triangles().iter().flat_map(sides).collect();
    assert_eq!(all.len(), 3 * hull.triangles().len());
    assert!(all.iter().all(|&[from, to]| all.contains(&[to, from])));
    assert_eq!(hull.triangles().len(), 2 * hull.vertices().len() - 4);
    for &[a, b, c] in hull.triangles() {
        let side = |p: &[f64; 3]| side_of_plane(&points[a], &points[b], &points[c], p);
        assert!(points.iter().all(|p| side(p) != Ordering::Greater));
    }
}

fn is_in_plane(points: &[[f64; 3]], [a, b, c]: [usize; 3], p: usize) -> bool {
    side_of_plane(&points[a], &points[b], &points[c], &points[p]) == Ordering::Equal
}

/// The points in the planes of the triangles, each list once.
fn planes(points: &[[f64; 3]], hull: &SolidHull) -> Vec<Vec<usize>> {
    let plane = |&t: &[usize; 3]| (0..points.len()).filter(|&p| is_in_plane(points, t, p)).collect();
    let planes: BTreeSet<Vec<usize>> = hull.triangles().iter().map(plane).collect();
    planes.into_iter().collect()
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-1i32..2).prop_map(f64::from),
        2 => (-9i32..9).prop_map(|i| f64::from(i) * 0.1),
        2 => -1.0..1.0f64,
        1 => prop::sample::select(vec![0.0, -0.0, 5e-324, 1e-160, 3e200, f64::MAX, -f64::MAX]),
    ]
}

properties! {
    #![proptest_config(crate::property_cases::config(1_000))]

    #[test]
    fn facets_are_those_of_the_truth(points in prop::collection::vec(prop::array::uniform3(coordinate()), 1..14)) {
        let truth = facets(&points).expect("finite points");
        let hull = solid_hull(&points).expect("finite points");
        prop_assert_eq!(hull.is_none(), truth.is_empty());
        let corners = hull_corners(&points).expect("finite points");
        let kept: Vec<[f64; 3]> = corners.iter().map(|&p| points[p]).collect();
        let Some(hull) = hull else {
            prop_assert_eq!(hull_corners(&kept).expect("finite points").len(), kept.len());
            return Ok(());
        };
        check_surface(&points, &hull);
        prop_assert_eq!(&hull.vertices(), &corners);
        // the hull of the corners has the same facets, each with some of its points
        let of_kept = facets(&kept).expect("finite points");
        prop_assert_eq!(of_kept.len(), truth.len());
        for facet in of_kept {
            let facet: Vec<usize> = facet.into_iter().map(|p| corners[p]).collect();
            prop_assert!(truth.iter().any(|whole| facet.iter().all(|p| whole.contains(p))));
        }
        prop_assert_eq!(planes(&points, &hull), truth);
    }
}

#[test]
fn points_of_a_lattice_with_holes_and_copies() {
    let lattice: Vec<[f64; 3]> =
        (0..1000).filter(|i| i % 7 != 3).map(|i| [i % 10, i / 10 % 10, i / 100].map(f64::from)).collect();
    let twice = [lattice.clone(), lattice].concat();
    let hull = solid_hull(&twice).expect("finite").expect("it spans space");
    check_surface(&twice, &hull);
    assert!(hull.volume(&twice) < 729.0);
}

#[test]
fn points_that_span_less_than_space() {
    assert_eq!(hull_corners(&[]), Err(HullError::Empty));
    assert_eq!(hull_corners(&[[1.0; 3]; 5]), Ok(vec![0]));
    let line: Vec<[f64; 3]> = [3.0, -1.0, 2.0, 7.0, 7.0].iter().map(|t| [1.0, 2.0 * t, *t]).collect();
    assert_eq!(hull_corners(&line), Ok(vec![1, 3]));
    let upright: Vec<[f64; 3]> = (0..25).map(|i| [2.0, f64::from(i % 5), f64::from(i / 5)]).collect();
    assert_eq!(hull_corners(&upright), Ok(vec![0, 4, 20, 24]));
    assert_eq!(solid_hull(&upright), Ok(None));
    assert!(matches!(hull_corners(&[[0.0, f64::NAN, 0.0]]), Err(HullError::NonFinite(_))));
}
