//! Bodies prepared by a cutting against the exact truth and the static kernel, on all families, with the least space,
//! the most, and one between; every proof is verified.

use families::bodies::BODY_FAMILIES;
use families::drawn::bodies::families;
use proptest::prelude::*;
use tests::body_questions::{Asked, asked};
use tests::runner::{cases, for_all};
use zonotope::Zonotope;
use zonotope::collision::prepared::by_cutting::PreparedByCutting;
use zonotope::collision::{Gauge, Query, brute_force, by_lad};
use zonotope::interop::verifier::check_location;

/// The questions of a long run for each of the fourteen families; each is put to three structures: 35,700 in all.
const CASES: u32 = 850;

/// The largest body of a long run.
const LARGEST_BODY: u32 = 512;

/// The spaces that n generators are prepared with: n, about n^1.5, n².
fn spaces(n: usize) -> [u64; 3] {
    let n = n as u64;
    [n, n * n.isqrt(), n * n]
}

/// The answer about a point is the truth, and its proof holds.
fn agrees(prepared: &PreparedByCutting, point: [f64; 3], truth: &Gauge<3>) -> Result<(), TestCaseError> {
    let query = Query::of_point(point, prepared.body()).expect("the families make finite numbers");
    let facet = prepared.facet(point, &mut ()).expect("the families make finite numbers");
    prop_assert_eq!(facet.status(), truth.location.status(), "{:?}", facet);
    let (value, error) = facet.value();
    let is_near = value == truth.value || (value - truth.value).abs() <= error + truth.error;
    prop_assert!(is_near, "{} ± {}, not {} ± {}", value, error, truth.value, truth.error);
    let location = facet.location().with_nearest_basis(&query);
    prop_assert_eq!(location.status(), facet.status());
    prop_assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()), "{:?}", location);
    Ok(())
}

#[test]
fn small_bodies_answer_as_the_truth_does() {
    for (family, generators) in families::<3>(8) {
        for_all(&asked(generators), CASES, |asked| {
            let truth = brute_force::gauge(&asked.displacement());
            let Asked { from, to, generators } = asked;
            let body = Zonotope::new(from, generators).expect("the families make finite numbers");
            for space in spaces(body.generators().len()) {
                let prepared = PreparedByCutting::new(body.clone(), space, 1, &mut ()).expect("between n and n²");
                agrees(&prepared, to, &truth)
                    .map_err(|error| TestCaseError::fail(format!("{family}, m = {space}: {error}")))?;
            }
            Ok(())
        });
    }
}

/// Points on the boundary of a body as far as doubles can say, inside and outside, and its vertices.
fn points(body: &Zonotope<3>) -> Vec<[f64; 3]> {
    let whole = |i: i32| [i * 7 % 5 - 2, i * 3 % 7 - 3, i * 5 % 11 - 5].map(f64::from);
    let directions = (0..12).map(whole).chain((0..12).map(|i| whole(i).map(|c| libm::cbrt(c - 0.3))));
    let mut points = vec![body.center()];
    for u in directions {
        let center = body.center();
        let vertex = body.support(u).point();
        let at = |factor: f64| [0, 1, 2].map(|k| center[k] + factor * u[k]);
        let gauge = by_lad::gauge(&Query::of_point(at(1.0), body).expect("the directions are finite"), &mut ()).value;
        let on_ray = if gauge.is_finite() && gauge > 0.0 { 1.0 / gauge } else { 1.0 };
        points.extend([vertex, at(0.5 * on_ray), at(on_ray), at(2.0 * on_ray)]);
    }
    points.retain(|point| point.iter().all(|c| c.is_finite()));
    points
}

#[test]
fn bodies_of_every_family_answer_as_the_static_kernel_does() {
    for family in BODY_FAMILIES {
        for n in [20, cases(LARGEST_BODY) as usize] {
            let body = Zonotope::new([0.5, -1.0, 0.0], family.generate(n, 3)).expect("the families are finite");
            let points = points(&body);
            for space in spaces(body.generators().len()) {
                let prepared = PreparedByCutting::new(body.clone(), space, 1, &mut ()).expect("between n and n²");
                for &point in &points {
                    let truth = by_lad::gauge(&Query::of_point(point, &body).expect("the points are finite"), &mut ());
                    let answer = agrees(&prepared, point, &truth);
                    assert!(answer.is_ok(), "{}, n = {n}, m = {space}, {point:?}: {answer:?}", family.id);
                }
            }
        }
    }
}
