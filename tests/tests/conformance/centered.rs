//! Z(O) for a given centre against the hull of the points and their reflections, on all point families.

use dashu_ratio::RBig;
use families::drawn::points::{Point, Points};
use paper_checks::definitions::plane;
use proptest::prelude::*;
use zonotope::enclosing::centered_zonogon::CenteredZonogon;
use zonotope::hull::antipodal::farthest_vertices;
use zonotope::hull::convex_hull;

const CASES: u32 = 300;

/// Points with a centre: one of the points, the middle of two, or one between them and beyond.
fn with_center(points: Points) -> impl Strategy<Value = (Vec<Point>, Point)> {
    let place = prop_oneof![Just(0.0), Just(0.5), Just(0.25), -1.0..2.0f64];
    (points, any::<[prop::sample::Index; 2]>(), place).prop_map(|(points, ends, place)| {
        let [one, other] = ends.map(|end| *end.get(&points));
        let center = [0, 1].map(|axis| one[axis] * (1.0 - place) + other[axis] * place);
        (points, center)
    })
}

fn agrees((points, center): (Vec<Point>, Point)) -> Result<(), TestCaseError> {
    prop_assume!(center.iter().all(|coordinate| coordinate.is_finite()));
    let hull = convex_hull(&points, &mut ()).map_err(|error| TestCaseError::fail(error.to_string()))?;
    let farthest = farthest_vertices(&hull, &mut ());
    let zonogon = CenteredZonogon::new(&hull, &farthest, center, &mut ());

    let given: Vec<plane::Point> = points.iter().copied().map(plane::Point::exactly).collect();
    let truth = plane::zonogon_about(&given, &plane::Point::exactly(center));
    let boundary: Vec<plane::Point> = zonogon
        .boundary()
        .map(|vertex| zonogon.exact_vertex(vertex).map(|coordinate| coordinate.to_rational()))
        .map(|[x, y]| plane::Point::new(x, y))
        .collect();
    prop_assert_eq!(plane::convex_hull(&boundary), truth.clone());
    prop_assert_eq!(zonogon.exact_area().to_rational(), plane::signed_area(&truth));
    prop_assert_eq!(plane::signed_area(&boundary), plane::signed_area(&truth), "the boundary is not in order");
    prop_assert!(boundary.len() <= (2 * hull.vertex_count()).max(4));
    let turns_right = |at: usize| {
        let [a, b, c] = [0, 1, 2].map(|step| &boundary[(at + step) % boundary.len()]);
        plane::turn(a, b, c) < RBig::ZERO
    };
    prop_assert!(!(0..boundary.len()).any(turns_right));

    let described: usize = zonogon
        .description()
        .iter()
        .map(|run| (run.last.get() + hull.vertex_count() - run.first.get()) % hull.vertex_count() + 1)
        .sum();
    prop_assert_eq!(described, boundary.len(), "the runs do not make up the boundary");
    Ok(())
}

tests::test_on_point_families!(with_center, CASES, agrees);
