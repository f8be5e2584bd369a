//! The convex hull and the farthest vertices against exact twins, on all point families.

use std::cmp::Ordering;
use std::convert::identity;

use families::clouds::SOLIDS;
use families::drawn::points::Point;
use paper_checks::definitions::plane;
use proptest::prelude::*;
use zonotope::hull::in_space::solid_hull;
use zonotope::hull::{antipodal, brute_force, convex_hull};
use zonotope::interop::verifier::check_convex_hull;

const CASES: u32 = 400;

fn exact(points: &[Point]) -> Vec<plane::Point> {
    points.iter().copied().map(plane::Point::exactly).collect()
}

fn agrees(points: Vec<Point>) -> Result<(), TestCaseError> {
    let hull = convex_hull(&points, &mut ()).map_err(|error| TestCaseError::fail(error.to_string()))?;
    let truth = plane::convex_hull(&exact(&points));
    prop_assert_eq!(exact(hull.vertices()), truth.clone());
    prop_assert_eq!(&hull, &brute_force::convex_hull(&points, &mut ()).expect("the default method took it"));
    prop_assert_eq!(check_convex_hull(&points, &hull).proof().map(drop), Ok(()));

    let farthest = antipodal::farthest_vertices(&hull, &mut ());
    prop_assert_eq!(farthest.len(), if truth.len() >= 3 { truth.len() } else { 0 });
    for (t, found) in farthest.iter().enumerate() {
        let expected = plane::farthest_vertices(&truth, t);
        let s = found.vertex().get();
        prop_assert!(expected.contains(&s), "edge {}: {} is not among {:?}", t, s, expected);
        prop_assert_eq!(found.is_tied(), expected.len() == 2);
        let next_ties = expected.contains(&((s + 1) % truth.len()));
        prop_assert_eq!(found.is_tied().cmp(&next_ties), Ordering::Equal);
    }
    Ok(())
}

tests::test_on_point_families!(identity, CASES, agrees);

/// Vertices of a Platonic solid are corners of its hull, whose volume is known.
#[test]
fn hulls_of_solids_have_their_volumes() {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let edge = 2.0 / golden;
    let expected = [
        8.0 / 3.0,
        4.0 / 3.0,
        8.0,
        5.0 / 12.0 * (3.0 + 5f64.sqrt()) * 8.0,
        (15.0 + 7.0 * 5f64.sqrt()) / 4.0 * edge * edge * edge,
    ];
    for (solid, volume) in SOLIDS.iter().zip(expected) {
        let points = (solid.vertices)();
        let hull = solid_hull(&points).expect("finite").expect("a solid spans space");
        assert_eq!(hull.vertices().len(), points.len(), "{}", solid.name);
        assert!((hull.volume(&points) / volume - 1.0).abs() < 1e-14, "{}", solid.name);
    }
}
