//! Prepared bodies against the static kernel and brute force, on bodies that are hard for a cutting; decisions about
//! bodies in general position and not.

use super::*;
use crate::collision::{Status, brute_force, by_lad};
use crate::interop::verifier::check_location;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::{Operation, OperationCounts};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// What kinds of generators there are, each with some for a random vector, a vector of whole numbers and a number.
type Kind = (&'static str, fn([f64; 3], [f64; 3], usize) -> [f64; 3]);

const KINDS: [Kind; 10] = [
    ("random", |v, _, _| v),
    ("lattice", |_, w, _| w),
    ("flat", |v, _, _| [v[0], v[1], v[0] - 2.0 * v[1]]),
    ("level", |v, _, _| [v[0], 0.0, v[2]]),
    ("vertical and level", |v, w, i| [[v[0], 0.0, 0.0], [0.0, 0.0, w[2]], [w[0], v[1], 0.0]][i % 3]),
    ("parallel", |_, w, i| [[1.0, 2.0, -1.0], [0.5, 0.0, 1.0], [3.0, -1.0, 1.0]][i % 3].map(|c| c * w[0])),
    ("on a cone", |v, _, _| [v[0], v[1], libm::sqrt(v[0] * v[0] + v[1] * v[1])]),
    ("uneven", |v, w, i| if i % 2 == 0 { v.map(|c| c * 1e-200) } else { w.map(|c| c * 1e200) }),
    ("of all sizes", |v, w, _| [0, 1, 2].map(|k| if w[k] == 0.0 { 0.0 } else { of_any_size(v[k]) })),
    ("at the ends of the range", |_, w, i| w.map(|c| c * [1e306, 5e-324, 1.0][i % 3])),
];

/// A number times a power of two between 2^−1000 and 2^1000 which its last digits choose, at times a denormal number or
/// one near the largest double.
fn of_any_size(value: f64) -> f64 {
    let digits = value.to_bits();
    match digits % 16 {
        0 => f64::from_bits(digits >> 4 & 0xff_ffff),
        1 => f64::MAX / 64.0 * value,
        _ => scale_by_power_of_two(value, (digits >> 4) as i64 % 2001 - 1000),
    }
}

fn body(kind: Kind, n: usize, random: &mut Pcg64Mcg) -> Zonotope<3> {
    let generators = (0..n).map(|i| {
        let v = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
        let w = [0, 1, 2].map(|_| f64::from(random.random_range(-3..4i32)));
        kind.1(v, w, i)
    });
    let generators = generators.collect();
    let center = [0, 1, 2].map(|_| if random.random_range(0..2) == 0 { 0.0 } else { random.random_range(-1.0..1.0) });
    Zonotope::new(center, generators).expect("finite")
}

/// The centre, points in random directions, sums of the generators with signs that belong to a vertex, an edge or a
/// facet, each as it is and one step off.
fn points(body: &Zonotope<3>, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
    let mut points = vec![body.center()];
    for round in 0..8 {
        let u = [0, 1, 2].map(|_| f64::from(random.random_range(-2..3i32)));
        let mut point = body.center();
        for v in body.generators() {
            let along: f64 = (0..3).map(|k| u[k] * v[k]).sum();
            let sign = if along == 0.0 { [0.0, 1.0, -0.5][round % 3] } else { along.signum() };
            point = [0, 1, 2].map(|k| point[k] + sign * v[k]);
        }
        let axis = round % 3;
        let mut beside = point;
        beside[axis] = beside[axis].next_up();
        let direction = [0, 1, 2].map(|_| random.random_range(-2.0..2.0));
        points.extend([point, beside, direction]);
    }
    points.retain(|point| point.iter().all(|c| c.is_finite()));
    points
}

#[test]
fn answers_are_those_of_the_static_kernel_and_verify() {
    let random = &mut Pcg64Mcg::seed_from_u64(1);
    let mut statuses = [0; 3];
    for kind in KINDS {
        for n in [0, 1, 2, 3, 4, 6, 9, 17, 40] {
            let body = body(kind, n, random);
            let points = points(&body, random);
            let n = n as u64;
            for space in [n, n * n.isqrt(), n * n] {
                let prepared = PreparedByCutting::new(body.clone(), space, 3, &mut ()).expect("between n and n²");
                for &point in &points {
                    let query = Query::of_point(point, &body).expect("finite");
                    let facet = prepared.facet(point, &mut ()).expect("finite");
                    let truth = by_lad::gauge(&query, &mut ());
                    let place = format!("{} n = {n} m = {space} {point:?}", kind.0);
                    assert_eq!(facet.status(), truth.location.status(), "{place}");
                    let (value, error) = facet.value();
                    let is_near = value == truth.value || (value - truth.value).abs() <= error + truth.error;
                    assert!(is_near, "{place}: {value} ± {error}, not {} ± {}", truth.value, truth.error);
                    let location = facet.location().with_nearest_basis(&query);
                    assert_eq!(location.status(), facet.status(), "{place}");
                    assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()), "{place}: {location:?}");
                    statuses[facet.status() as usize] += 1;
                }
            }
        }
    }
    assert!(statuses.iter().all(|&count| count > 400), "{statuses:?}");
}

#[test]
fn small_bodies_answer_as_brute_force_does() {
    let random = &mut Pcg64Mcg::seed_from_u64(2);
    for kind in KINDS {
        for n in 0..7 {
            let body = body(kind, n, random);
            let prepared = PreparedByCutting::new(body.clone(), (n * n) as u64, 0, &mut ()).expect("between n and n²");
            for point in points(&body, random) {
                let query = Query::of_point(point, &body).expect("finite");
                let truth = brute_force::gauge(&query);
                let gauge = prepared.gauge(point).expect("finite");
                assert_eq!(gauge.location.status(), truth.location.status(), "{} {n} {point:?}", kind.0);
                let is_near = (gauge.value - truth.value).abs() <= gauge.error + truth.error;
                assert!(is_near || gauge.value == truth.value, "{} {n} {point:?}: {gauge:?} {truth:?}", kind.0);
            }
        }
    }
}

#[test]
fn the_seed_decides_no_answer() {
    let random = &mut Pcg64Mcg::seed_from_u64(3);
    let body = body(KINDS[1], 30, random);
    let [first, second] =
        [1, 2].map(|seed| PreparedByCutting::new(body.clone(), 300, seed, &mut ()).expect("between n and n²"));
    for point in points(&body, random) {
        let [own, other] = [&first, &second].map(|prepared| prepared.facet(point, &mut ()).expect("finite"));
        assert_eq!((own.value(), own.status()), (other.value(), other.status()), "{point:?}");
    }
}

#[test]
fn spaces_outside_of_the_range_are_refused() {
    let square = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
    let error =
        |space| PreparedByCutting::new(square.clone(), space, 0, &mut ()).map(drop).expect_err("outside of the range");
    assert_eq!(error(1), PreparationError::TooLittleSpace { space: 1, generators: 2 });
    assert_eq!(error(5), PreparationError::TooMuchSpace { space: 5, generators: 2 });
    assert_eq!(error(5).to_string(), "a space of 5 is more than the square of the number of generators, 2");
    let prepared = PreparedByCutting::new(square, 4, 0, &mut ()).expect("n²");
    assert!(prepared.contains([f64::NAN, 0.0, 0.0]).is_err() && prepared.locate([0.0, f64::INFINITY, 0.0]).is_err());
}

/// A member of a flat body is on its boundary, and off its span the gauge is infinite.
#[test]
fn flat_bodies_have_no_inside() {
    let square = Zonotope::new([1.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
    let prepared = PreparedByCutting::new(square, 4, 0, &mut ()).expect("n²");
    let facet = |point| prepared.facet(point, &mut ()).expect("finite");
    assert_eq!((facet([1.0; 3]).value(), facet([1.0; 3]).status()), ((0.0, 0.0), Status::Boundary));
    assert_eq!((facet([1.5, 1.0, 1.0]).value().0, facet([1.5, 1.0, 1.0]).status()), (0.5, Status::Boundary));
    assert_eq!(facet([1.0, 1.0, 2.0]).value(), (f64::INFINITY, 0.0));
    assert!(!facet([1.0, 1.0, 2.0]).is_member());
}

/// What a query does in its trapezoid falls with the space, to a fourth at least with eight times as much; what it does
/// to find it stays within ten times log² n.
#[test]
fn more_space_makes_queries_cheaper() {
    let random = &mut Pcg64Mcg::seed_from_u64(4);
    let body = body(KINDS[0], 1024, random);
    let directions: Vec<[f64; 3]> = (0..50).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0))).collect();
    let cost = |space: u64| {
        let prepared = PreparedByCutting::new(body.clone(), space, 0, &mut ()).expect("between n and n²");
        assert!(prepared.bytes() < 400 * space, "{} bytes for {space}", prepared.bytes());
        let mut counts = OperationCounts::default();
        for &point in &directions {
            prepared.facet(point, &mut counts).expect("finite");
        }
        let of = |operations: &[Operation]| operations.iter().map(|o| counts.get(*o)).sum::<u64>() / 50;
        let location = of(&[Operation::SearchStep, Operation::Comparison, Operation::LineEvaluation]);
        (location, of(&[Operation::GeneratorRead, Operation::PartEvaluation]))
    };
    let [(_, whole), (location, eighth), (_, small)] = [1024, 8192, 65536].map(cost);
    assert!(4 * eighth < whole && 4 * small < eighth, "{whole}, {eighth}, {small}");
    assert!(location < 10 * 100, "{location} is much more than log² n");
}
