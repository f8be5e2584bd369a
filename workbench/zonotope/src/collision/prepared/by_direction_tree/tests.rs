use super::*;
mod placed;

use crate::collision::{Location, Status, brute_force, by_lad};
use crate::interop::verifier::check_location;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::generators::Generators;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{dot, exact};
use crate::numeric::linear;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

pub(super) const KINDS: usize = 8;

/// Generators of eight kinds: even; few directions; whole numbers; nearly in a plane; on a cone; in a plane; of lengths
/// far apart; at the ends of the range of doubles.
pub(super) fn body(kind: usize, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
    (0..n)
        .map(|i| {
            let [x, y, z] = [0; 3].map(|_| random.random_range(-1.0..1.0f64));
            match kind {
                0 => [x, y, z],
                1 => [[1.0, 0.5, 0.0], [0.0, 1.0, -1.0], [1.0, 1.0, 1.0]][i % 3].map(|c| c * x),
                2 => [x, y, z].map(|c| (3.0 * c).round()),
                3 => [x, y, x + 1e-7 * z],
                4 => [0.5 * libm::cos(9.0 * x), 0.5 * libm::sin(9.0 * x), 1.0],
                5 => [x, y, x - y],
                6 => [x, y, z].map(|c| c * libm::exp10(60.0 * x)),
                _ => [x, y, z].map(|c| c * if i % 2 == 0 { f64::MAX } else { f64::from_bits(9) }),
            }
        })
        .collect()
}

/// A point that many coefficients at the ends make up, taken so many times.
fn point(rows: &[[f64; 3]], factor: f64, random: &mut Pcg64Mcg) -> [f64; 3] {
    let u = [0; 3].map(|_| random.random_range(-1.0..1.0));
    let sum = rows.iter().fold([0.0; 3], |sum, v| {
        let sign = f64::copysign(1.0, linear::dot(v, &u));
        [0, 1, 2].map(|k| sum[k] + sign * v[k])
    });
    // sums of the largest doubles may be anything
    sum.map(|c| factor * c).map(|c| if c.is_nan() { 0.0 } else { c.clamp(-f64::MAX, f64::MAX) })
}

/// Everything that a tree says of a point, against a location that is right.
fn check(tree: &DirectionTree, query: &Query<'_, 3>, truth: &Location<3>) {
    let located = tree.locate(query.to(), &mut ()).expect("finite");
    assert_eq!(located.status(), truth.status(), "{} generators", query.len());
    let written = located.expand();
    assert_eq!(written.status(), truth.status());
    assert_eq!(check_location(query, &written).proof().map(drop), Ok(()));
    match located.certificate() {
        Certificate::Separation(_) => assert_eq!(truth.status(), Status::Outside),
        Certificate::Facet { basis, .. } => assert!(basis.len() <= 2 && located.is_member()),
        Certificate::Sums(parts) => assert!(parts.len() <= FIRST_FRONT && located.status() == Status::Inside),
        Certificate::Written(witness) => assert_eq!(witness.coefficients.len(), query.len()),
    }
    let measured = tree.gauge(query.to(), &mut ()).expect("finite");
    let gauge = by_lad::gauge(query, &mut ());
    assert_eq!(measured.location.status(), truth.status());
    assert_eq!(check_location(query, &measured.location.expand()).proof().map(drop), Ok(()));
    let is_same = measured.value == gauge.value || (measured.value - gauge.value).abs() <= measured.error + gauge.error;
    assert!(is_same, "{} ± {}, not {} ± {}", measured.value, measured.error, gauge.value, gauge.error);
}

#[test]
fn a_cube_worked_out_by_hand() {
    let axes = vec![[0.0, -1.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let tree = DirectionTree::new(&Zonotope::new([1.0, 0.0, 0.0], axes).expect("finite"));
    for (point, status, gauge) in [
        ([1.0, 0.0, 0.0], Status::Inside, 0.0),
        ([1.5, 0.5, 0.0], Status::Inside, 0.5),
        ([2.0, 0.5, -1.0], Status::Boundary, 1.0),
        ([0.0, -3.0, 0.0], Status::Outside, 3.0),
    ] {
        assert_eq!(tree.locate(point, &mut ()).map(|located| located.status()), Ok(status));
        assert_eq!(tree.gauge(point, &mut ()).expect("finite").value, gauge);
    }
    let top = tree.support([0.0, 0.0, 2.0]).expect("finite");
    // a generator that is orthogonal to the direction has the coefficient 1
    assert_eq!((top.value(), top.point()), (2.0, [2.0, -1.0, 1.0]));
    assert!(tree.locate([f64::NAN; 3], &mut ()).is_err() && tree.support([f64::INFINITY; 3]).is_err());
    let none = DirectionTree::new(&Zonotope::new([0.0; 3], vec![]).expect("finite"));
    assert_eq!(none.locate([0.0; 3], &mut ()).map(|located| located.status()), Ok(Status::Boundary));
    assert_eq!(none.contains([0.0, 0.0, 1e-300]), Ok(false));
    assert!(none.is_empty() && tree.len() == 4);
}

#[test]
fn small_bodies_are_located_as_by_the_definition() {
    let random = &mut Pcg64Mcg::seed_from_u64(3);
    for kind in 0..KINDS {
        for n in [1, 3, 9] {
            let rows = body(kind, n, random);
            let tree = DirectionTree::new(&Zonotope::new([0.0; 3], rows.clone()).expect("finite"));
            for factor in [0.0, 0.3, 1.0, 1.0 + 1e-15, 1.7] {
                let query = Query::of_finite([0.0; 3], point(&rows, factor, random), &rows);
                check(&tree, &query, &brute_force::locate(&query));
            }
        }
    }
}

#[test]
fn many_generators_are_located_as_without_a_tree() {
    let random = &mut Pcg64Mcg::seed_from_u64(5);
    for kind in 0..KINDS {
        for n in [130, 700, 2500] {
            let rows = body(kind, n, random);
            let center = [0.25, -3.0, 7.0];
            let tree = DirectionTree::new(&Zonotope::new(center, rows.clone()).expect("finite"));
            for factor in [0.4, 0.97, 1.0, 1.0 + 1e-9, 1.3] {
                let p = point(&rows, factor, random);
                let query = Query::of_finite(center, [0, 1, 2].map(|k| p[k] + center[k]), &rows);
                check(&tree, &query, &by_lad::locate(&query, &mut ()));
            }
        }
    }
}

#[test]
fn supports_are_those_of_a_pass() {
    let random = &mut Pcg64Mcg::seed_from_u64(7);
    for kind in 0..KINDS {
        for n in [5, 300, 1500] {
            let body = Zonotope::new([0.5, 0.0, -1.0], body(kind, n, random)).expect("finite");
            let tree = DirectionTree::new(&body);
            let normal = linear::cross(&body.generators()[0], &body.generators()[n - 1]);
            let any = [0; 3].map(|_| random.random_range(-1.0..1.0));
            for u in [any, normal, [0.0, 0.0, 1.0], [1.0, 0.0, -1.0], [0.0; 3]] {
                let u = u.map(|c| if c.is_finite() { c } else { 1.0 });
                let truth = body.support(u);
                assert_eq!(tree.support(u), Ok(truth), "{kind} {n}");
            }
        }
    }
}

#[test]
fn the_sum_over_a_cell_is_within_its_bound_and_no_sign_is_wrong() {
    let random = &mut Pcg64Mcg::seed_from_u64(11);
    for kind in 0..6 {
        let rows = body(kind, 3000, random);
        let tree = DirectionTree::new(&Zonotope::new([0.0; 3], rows).expect("finite"));
        let query = tree.placed().query_about([1.0, 0.0, 0.0]).expect("finite");
        for round in 0..20 {
            let mut vector = |size: f64| [0; 3].map(|_| size * random.random_range(-1.0..1.0));
            let size = [0.0, 1e-9, 1e-3, 0.1][round % 4];
            let (center, axes) = (vector(1.0), [vector(size), vector(size)]);
            let cell = DirectionCone { center, axes: (round % 3 > 0).then_some(axes), ball: size / 4.0 };
            let (mut crossing, mut places) = (Vec::new(), Default::default());
            let fixed = query.split(&cell, &mut crossing, &mut places);
            assert!(places.is_sorted() && crossing.len() == places.len());
            let mut truth = exact([0.0; 3]);
            for (i, v) in tree.rows.iter().enumerate() {
                if places.binary_search(&(i as u32)).is_ok() {
                    continue;
                }
                let sign = cell.value(v).signum();
                truth = [0, 1, 2].map(|k| &truth[k] + &Dyadic::from_f64(sign * v[k]));
                let corners = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
                for [a, b] in corners.into_iter().filter(|_| cell.axes.is_some()) {
                    let u = [0, 1, 2].map(|k| center[k] + a * axes[0][k] + b * axes[1][k]);
                    assert!(sign * linear::dot(v, &u) > -1e-15, "a sign changes within the cell");
                }
            }
            for (truth, sum) in truth.into_iter().zip(fixed.sum) {
                let off = (truth - Dyadic::from_f64(sum)).abs();
                assert!(off <= Dyadic::from_f64(fixed.error), "{kind}: {} {:e}", off.to_f64(), fixed.error);
            }
            assert!(tree.rows.iter().map(linear::euclidean_norm).sum::<f64>() <= fixed.magnitude);
        }
    }
}

#[test]
fn exact_sums_leave_out_what_is_orthogonal() {
    let rows = vec![[1.0, 2.0, 3.0], [0.0, -1.0, 0.0], [3.0, 0.0, -1.0], [0.5, 0.25, 0.0]];
    let tree = DirectionTree::new(&Zonotope::new([0.0; 3], rows).expect("finite"));
    // the first is orthogonal to (1, 1, −1); of the others 1, 4 and 0.75 are the products' magnitudes
    let u = exact([1.0, 1.0, -1.0]);
    let (sum, orthogonal) = tree.exact_sum_along(&u).expect("short coordinates");
    assert_eq!(dot(&sum, &u), Dyadic::from_f64(5.75));
    assert_eq!(orthogonal.iter().map(|&place| tree.places[place as usize]).collect::<Vec<_>>(), [0]);
}

#[test]
fn a_large_body_is_asked_without_a_pass() {
    use crate::tally::{Operation, OperationCounts};
    let random = &mut Pcg64Mcg::seed_from_u64(13);
    let n = 1 << 16;
    let rows = body(0, n, random);
    let tree = DirectionTree::new(&Zonotope::new([0.0; 3], rows).expect("finite"));
    assert!(tree.bytes() < 2 * 24 * n, "{} bytes", tree.bytes());
    for _ in 0..10 {
        let p = [0; 3].map(|_| random.random_range(-1.0..1.0));
        let mut counts = OperationCounts::default();
        let gauge = tree.gauge(p, &mut counts).expect("finite").value;
        assert!(counts.get(Operation::GeneratorRead) < n as u64 / 8, "{counts:?}");
        for (factor, status) in [(0.5, Status::Inside), (1.0 - 1e-9, Status::Inside), (1.0 + 1e-9, Status::Outside)] {
            let mut counts = OperationCounts::default();
            let located = tree.locate(p.map(|c| factor * c / gauge), &mut counts).expect("finite");
            assert_eq!(located.status(), status);
            assert!(counts.get(Operation::GeneratorRead) < n as u64 / 8, "{counts:?}");
        }
    }
}
