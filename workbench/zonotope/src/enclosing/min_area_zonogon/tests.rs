//! The answer against the truth on every family of points.

use proptest::prelude::*;

use super::exact::exact_optimum;
use super::*;
use crate::enclosing::min_area;
use crate::interop::verifier::{check_exact_min_area, check_min_area};
use crate::lad::{LineIndex, Minimizer};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::zonotope::Zonotope;

fn check(points: &[[f64; 2]]) -> Result<(), TestCaseError> {
    let (least, centers) = brute_force::least_area(points);
    for method in Method::ALL {
        let answer = method.solve(points, 1, &mut ()).expect("finite points");
        let exact = exact_optimum(&answer);
        prop_assert_eq!(&exact.area, &least, "{:?} {:?}", method, answer);
        prop_assert!(centers.is_empty() || centers.contains(&exact.center));
        if answer.proof.hull.has_area() {
            prop_assert_eq!(answer.proof.face_dimension == 0, centers.len() == 1);
        }
        let verdict = check_min_area(points, &answer);
        prop_assert!(verdict.is_right(), "{:?}: {:?} {:?}", method, verdict, answer);
        let verdict = check_exact_min_area(points, &answer);
        prop_assert!(verdict.is_right(), "{:?}: {:?} {:?}", method, verdict, answer);
        prop_assert!(Dyadic::from_f64(answer.lower_bound).to_rational() <= least);
        prop_assert!(!answer.value.is_finite() || Dyadic::from_f64(answer.value).to_rational() >= least);
    }
    Ok(())
}

/// Whether doubles are fine enough for a relative excess of 1e-12: the hull is neither thin nor far from the origin.
fn excess_is_small(points: &[[f64; 2]]) -> bool {
    let answer = min_area(points).expect("finite points");
    answer.relative_gap() <= 1e-12
}

fn lattice() -> impl Strategy<Value = f64> + Clone {
    (-4i32..5).prop_map(f64::from)
}

fn scale() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        Just(1.0),
        Just(1e-300),
        Just(1e300),
        Just(1e-5),
        Just(f64::from_bits(1)),
        Just(1e150),
        Just(1e308 / 4.0)
    ]
}

properties! {
    #![proptest_config(crate::property_cases::config(400))]

    #[test]
    fn random_points(points in proptest::collection::vec([-1.0..1.0f64, -1.0..1.0], 1..9)) {
        check(&points)?;
    }

    #[test]
    fn random_points_have_a_small_gap(points in proptest::collection::vec([-1.0..1.0f64, -1.0..1.0], 6..30)) {
        prop_assert!(excess_is_small(&points));
    }

    #[test]
    fn lattice_points(points in proptest::collection::vec([lattice(), lattice()], 1..9)) {
        check(&points)?;
    }

    #[test]
    fn points_of_one_magnitude(points in proptest::collection::vec([lattice(), lattice()], 1..8), s in scale()) {
        let points: Vec<_> = points.iter().map(|p| p.map(|v| v * s)).collect();
        check(&points)?;
    }

    #[test]
    fn points_of_all_magnitudes(
        points in proptest::collection::vec([(lattice(), scale()), (lattice(), scale())], 1..6),
    ) {
        let points: Vec<_> = points.iter().map(|p| p.map(|(v, s)| v * s)).collect();
        check(&points)?;
    }

    #[test]
    fn symmetric_points(
        points in proptest::collection::vec([lattice(), lattice()], 1..6),
        o in [lattice(), lattice()],
    ) {
        let reflected = points.iter().map(|p| [o[0] - p[0], o[1] - p[1]]);
        let points: Vec<_> = points.iter().copied().chain(reflected).collect();
        check(&points)?;
    }

    #[test]
    fn nearly_collinear_points(
        points in proptest::collection::vec((0i32..9, -2i64..3), 1..8),
        slope in prop_oneof![Just(1.0), Just(0.1), Just(0.3), Just(1e-12)],
    ) {
        let nudge = |v: f64, by: i64| f64::from_bits((v.to_bits() as i64 + by) as u64);
        let points: Vec<_> =
            points.iter().map(|&(x, by)| [f64::from(x), nudge(1.0 + slope * f64::from(x), by)]).collect();
        check(&points)?;
    }
}

#[test]
fn a_triangle_by_hand() {
    let answer = min_area(&[[0.0, 0.0], [6.0, 0.0], [0.0, 3.0]]).expect("finite points");
    assert_eq!((answer.value, answer.lower_bound > 18.0 - 1e-12, answer.proof.face_dimension), (18.0, true, 2));
}

#[test]
fn one_point_and_two_points_have_no_area() {
    let point = min_area(&[[3.0, 4.0]; 3]).expect("finite points");
    assert_eq!((point.value, point.body.center(), point.body.generators().len()), (0.0, [3.0, 4.0], 0));
    let segment = min_area(&[[1.0, 1.0], [3.0, 2.0], [5.0, 3.0]]).expect("finite points");
    assert_eq!((segment.value, segment.body.center()), (0.0, [3.0, 2.0]));
    assert_eq!(segment.body.generators(), [[2.0, 1.0]]);
    assert_eq!(exact_optimum(&segment).area, Rational::ZERO);
}

#[test]
fn centers_at_the_largest_double() {
    // optimal centres within half a unit in the last place of it, from both sides, and beyond it in rounding
    let (largest, next) = (f64::MAX, f64::MAX.next_down());
    let coordinates = [largest, next, next.next_down(), -largest, 0.0, 1.0];
    let points: Vec<[f64; 2]> = coordinates.iter().flat_map(|&x| coordinates.map(|y| [x, y])).collect();
    for i in 0..points.len() {
        for j in (0..i).step_by(3) {
            for k in (0..j).step_by(5) {
                check(&[points[i], points[j], points[k]]).expect("the answer is the truth");
            }
        }
    }
}

#[test]
fn regular_polygons_of_any_aspect_are_verified() {
    for count in [5, 6, 33, 34, 51, 52, 129, 130, 1001, 1002] {
        for height in [1.0, 0.3, 1e-3, 1e-6, 1e-300, 1e300] {
            let point = |i: usize| {
                let (sin, cos) = libm::sincos(i as f64 * std::f64::consts::TAU / f64::from(count));
                [cos, height * sin]
            };
            let points: Vec<[f64; 2]> = (0..count as usize).map(point).collect();
            let answer = min_area(&points).expect("finite points");
            let verdict = check_min_area(&points, &answer).proof().map(drop);
            assert_eq!(verdict, Ok(()), "{count} points of height {height:e}");
            if count < 10 {
                check(&points).expect("the answer is the truth");
            }
        }
    }
}

#[test]
fn regular_polygons_of_few_corners_are_the_truth_anywhere() {
    for count in [3, 4, 5, 7, 8, 9] {
        for (radius, center) in [(1.0, 0.0), (0.1, 0.3), (1e-160, 1e-160), (1e-310, 0.0), (1.0, 1e15)] {
            let point = |i: usize| {
                let (sin, cos) = libm::sincos(i as f64 * std::f64::consts::TAU / f64::from(count));
                [radius * cos + center, radius * sin - center]
            };
            let points: Vec<[f64; 2]> = (0..count as usize).map(point).collect();
            check(&points).expect("the answer is the truth");
        }
    }
}

#[test]
fn many_vertices_at_the_smallest_doubles() {
    for (count, radius) in [(129, 1e-310), (200, 1e-318), (700, 1e-309), (700, 1e-318)] {
        let point = |i: usize| {
            let (sin, cos) = libm::sincos(i as f64 * std::f64::consts::TAU / count as f64);
            [radius * cos, radius * sin]
        };
        let points: Vec<[f64; 2]> = (0..count).map(point).collect();
        let answer = min_area(&points).expect("finite points");
        assert_eq!(check_min_area(&points, &answer).proof().map(drop), Ok(()), "{count} points at {radius:e}");
    }
}

#[test]
fn falsified_answers_are_rejected() {
    let points = [[0.0, 0.0], [6.0, 0.0], [2.0, 5.0], [7.0, 3.0]];
    let right = || min_area(&points).expect("finite points");
    assert!(check_min_area(&points, &right()).is_right() && check_exact_min_area(&points, &right()).is_right());
    let rejected = |change: &dyn Fn(&mut MinAreaZonogon), reason: &str| {
        let mut answer = right();
        change(&mut answer);
        let complaint = check_min_area(&points, &answer).proof().expect_err("something is wrong");
        assert!(complaint.contains(reason), "{complaint}");
    };
    for area in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.0, 1e9] {
        rejected(&|answer| answer.value = area, "area is");
    }
    for bound in [f64::NAN, f64::INFINITY, 1e9] {
        rejected(&|answer| answer.lower_bound = bound, "lower_bound");
    }
    // The optimal centres of these points are a face: some other vertices of the arrangement are none of it.
    let is_wrong_at = |first: u32, second: u32| {
        let mut elsewhere = right();
        elsewhere.proof.minimizer = Minimizer::Vertex(LineIndex(first), LineIndex(second));
        check_exact_min_area(&points, &elsewhere).is_wrong()
    };
    assert!((0..4).any(|second| (0..second).any(|first| is_wrong_at(first, second))));
    let larger = |answer: &mut MinAreaZonogon| {
        let mut generators = answer.body.generators().to_vec();
        generators.push([1e-9, 0.0]);
        answer.body = Zonotope::new(answer.body.center(), generators).expect("finite");
        answer.value = answer.body.exact_area().to_f64().next_up();
    };
    rejected(&larger, "above the proven bound");
}

#[test]
fn the_bound_of_an_area_beyond_the_doubles_is_the_largest_double() {
    let points = [[0.3, 0.1], [1.7, -0.4], [0.9, 1.3], [-0.6, 0.7], [0.2, -1.1], [-1.3, -0.8]];
    for scale in [1e155, 1e160, 1e200, 1e300, 1e307] {
        let scaled = points.map(|point| point.map(|c| c * scale));
        let answer = crate::enclosing::min_area(&scaled).expect("the points are finite");
        assert_eq!((answer.value, answer.lower_bound), (f64::INFINITY, f64::MAX), "{scale:e}");
    }
}
