//! The whole of section 4.1 against the exact twin, with every method of the kernel, on all point families.

use std::convert::identity;

use dashu_ratio::RBig;
use families::drawn::numbers::power_of_two;
use families::drawn::points::Point;
use paper_checks::definitions::plane;
use proptest::prelude::*;
use tests::kernel_twin::exactly;
use tests::runner::for_all;
use zonotope::enclosing::min_area_zonogon::exact::exact_optimum;
use zonotope::enclosing::min_area_zonogon::{Method, MinAreaZonogon, brute_force};
use zonotope::interop::verifier::{check_exact_min_area, check_min_area};

const CASES: u32 = 250;

fn exact(points: &[Point]) -> Vec<plane::Point> {
    points.iter().copied().map(plane::Point::exactly).collect()
}

/// The least area and where it is attained, by the twin: zero for a hull without area, whatever the centre.
fn truth(hull: &[plane::Point]) -> (RBig, Vec<plane::Point>) {
    if hull.len() < 3 { (RBig::ZERO, Vec::new()) } else { plane::least_area(hull) }
}

fn agrees(points: Vec<Point>) -> Result<(), TestCaseError> {
    let given = exact(&points);
    let hull = plane::convex_hull(&given);
    let (least, centers) = truth(&hull);
    prop_assert_eq!(&brute_force::least_area(&points).0, &least);

    for method in Method::ALL {
        let answer = method.solve(&points, 5, &mut ()).map_err(|error| TestCaseError::fail(error.to_string()))?;
        let verdict = check_min_area(&points, &answer);
        prop_assert!(verdict.is_right(), "{:?}: {:?}", method, verdict);
        let verdict = check_exact_min_area(&points, &answer);
        prop_assert!(verdict.is_right(), "{:?}: {:?}", method, verdict);

        let optimum = exact_optimum(&answer);
        let center = plane::Point::new(optimum.center[0].clone(), optimum.center[1].clone());
        prop_assert_eq!(&optimum.area, &least, "{:?}", method);
        if hull.len() >= 3 {
            prop_assert_eq!(&plane::zonogon_area(&hull, &center), &least, "{:?}", method);
            prop_assert_eq!(answer.proof.face_dimension() == 0, centers.len() == 1, "{:?}", method);
        }
        encloses(&given, &answer)?;
        bounds_hold(&points, &least, &answer)?;
    }
    Ok(())
}

fn encloses(points: &[plane::Point], answer: &MinAreaZonogon) -> Result<(), TestCaseError> {
    let center = plane::Point::exactly(answer.body.center());
    let generators: Vec<plane::Point> = answer.body.generators().iter().copied().map(plane::Point::exactly).collect();
    for point in points {
        let inside = plane::generated_zonogon_contains(&center, &generators, point);
        prop_assert!(inside, "{} lies outside", point);
    }
    Ok(())
}

/// The area is between the optimum and the optimum with what rounding the centre and the generators may cost: nothing
/// to speak of, unless the hull is thin or far from the origin for its size.
fn bounds_hold(points: &[Point], least: &RBig, answer: &MinAreaZonogon) -> Result<(), TestCaseError> {
    prop_assert!(exactly(answer.lower_bound) <= *least);
    prop_assert!(answer.lower_bound >= 0.0 && answer.value >= answer.lower_bound);
    let coordinates = || points.iter().flatten().map(|value| exactly(value.abs()));
    let largest = coordinates().max().unwrap_or(RBig::ZERO);
    let spread = |axis: usize| {
        let values = || points.iter().map(|point| exactly(point[axis]));
        values().max().unwrap_or(RBig::ZERO) - values().min().unwrap_or(RBig::ZERO)
    };
    let unit = exactly(power_of_two(-44));
    let smallest = exactly(f64::MIN_POSITIVE);
    let excess = exactly(1e-12) * least + unit * largest * (spread(0) + spread(1)) + smallest;
    let upper = least + &excess;
    let out_of_range = upper > exactly(f64::MAX);
    if answer.value.is_finite() {
        let area = exactly(answer.value);
        prop_assert!(area >= *least && area <= upper, "area {} of {:e}", answer.value, least.to_f64_fast());
    } else {
        prop_assert!(out_of_range, "the area {:e} is a double", least.to_f64_fast());
    }
    let tight = out_of_range || exactly(answer.lower_bound) + excess >= *least;
    prop_assert!(tight, "bound {} of {:e}", answer.lower_bound, least.to_f64_fast());
    Ok(())
}

tests::test_on_point_families!(identity, CASES, agrees);

/// Hulls that are neither thin nor far from the origin keep within a relative 1e-12.
#[test]
fn the_excess_is_small() {
    let fat = proptest::collection::vec([-1.0..1.0f64, -1.0..1.0], 8..60);
    for_all(&fat, 400, |points| {
        let answer =
            Method::default().solve(&points, 0, &mut ()).map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert!(answer.relative_gap() <= 1e-12, "{}", answer.relative_gap());
        Ok(())
    });
}
