//! Every rule against the exact truth and against its own proof, on small bodies of every kind.

use proptest::prelude::*;
use zonotope::Zonotope;
use zonotope::reduction::brute_force::contains;
use zonotope::reduction::by_patches::{patch_count, patches_within};
use zonotope::reduction::hausdorff::by_vertices::hausdorff_at_vertices;
use zonotope::reduction::hausdorff::{Distance, excess};
use zonotope::reduction::{self, Containment, Method, Problem, Reduced, ReductionError};

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-4..=4i32).prop_map(f64::from),
        3 => -1.0..1.0f64,
        1 => (-4..=4i32).prop_map(|c| f64::from(c) * 1e-13),
        1 => (-4..=4i32).prop_map(|c| f64::from(c) * f64::from_bits(1)),
        1 => (-4..=4i32).prop_map(|c| f64::from(c) * 2f64.powi(1018)),
    ]
}

fn body<const D: usize>(generators: &[[f64; D]]) -> Zonotope<D> {
    let center = std::array::from_fn(|k| k as f64 / 3.0);
    Zonotope::new(center, generators.to_vec()).expect("the numbers are finite")
}

fn encloses<const D: usize>(inner: &Zonotope<D>, reduced: &Reduced<D>, name: &str) -> Result<(), TestCaseError> {
    prop_assert_eq!(reduced.body.center(), inner.center());
    prop_assert!(contains(&reduced.body, inner), "{}: {:?}", name, reduced.body);
    if let Containment::Shares(shares) = &reduced.proof {
        prop_assert_eq!(shares.check(inner, &reduced.body), Ok(()), "{}: {:?}", name, reduced);
    }
    Ok(())
}

fn every_rule_encloses<const D: usize>(generators: &[[f64; D]]) -> Result<(), TestCaseError> {
    let inner = body(generators);
    for count in D..=generators.len() {
        let problem = Problem::new(&inner, count).expect("the count is at least the dimension");
        for method in Method::ALL {
            match method.reduce(&problem) {
                Ok(reduced) => {
                    prop_assert!(reduced.body.generators().len() <= count, "{}", method.id());
                    encloses(&inner, &reduced, method.id())?;
                }
                Err(error) => {
                    let largest = generators.as_flattened().iter().fold(0.0f64, |m, c| m.max(c.abs()));
                    prop_assert_eq!(error, ReductionError::OutOfRange);
                    prop_assert!(largest > 1e300, "{}", method.id());
                }
            }
        }
    }
    for epsilon in [0.5, 0.01] {
        match patches_within(&inner, epsilon, &mut ()) {
            Ok(reduced) => encloses(&inner, &reduced, "to a precision")?,
            Err(error) => prop_assert_eq!(error, ReductionError::OutOfRange),
        }
    }
    Ok(())
}

tests::properties! {
    48;

    #[test]
    fn every_rule_encloses_in_the_plane(
        generators in proptest::collection::vec(proptest::array::uniform2(number()), 2..8),
    ) {
        every_rule_encloses(&generators)?;
    }

    #[test]
    fn every_rule_encloses_in_space(
        generators in proptest::collection::vec(proptest::array::uniform3(number()), 3..8),
    ) {
        every_rule_encloses(&generators)?;
    }

    #[test]
    fn every_rule_encloses_in_r4(
        generators in proptest::collection::vec(proptest::array::uniform4(number()), 4..7),
    ) {
        every_rule_encloses(&generators)?;
    }
}

tests::properties! {
    256;

    #[test]
    fn containment_on_a_line_agrees_with_brute_force(
        lines in proptest::array::uniform2(proptest::collection::vec(proptest::array::uniform1(number()), 0..3)),
        centers in proptest::array::uniform2(proptest::array::uniform1(number())),
    ) {
        let [a, b] = [0, 1].map(|i| Zonotope::new(centers[i], lines[i].clone()).expect("the numbers are finite"));
        prop_assert_eq!(reduction::contains(&a, &b), Some(contains(&a, &b)));
    }
}

/// Generators of small whole numbers, and the same with all coordinates an ulp higher.
fn an_ulp_apart<const D: usize>(count: usize) -> [Zonotope<D>; 2] {
    let coordinate = |i: usize, k: usize| ((i * i * (k + 2) + 3 * i + 5 * k) % 7) as f64 - 3.0;
    let generators: Vec<[f64; D]> = (0..count).map(|i| std::array::from_fn(|k| coordinate(i + 1, k))).collect();
    let moved: Vec<[f64; D]> = generators.iter().map(|g| g.map(f64::next_up)).collect();
    [generators, moved].map(|list| Zonotope::new([0.0; D], list).expect("the numbers are finite"))
}

#[test]
fn bodies_an_ulp_apart_take_few_operations_in_rationals() {
    // more than the limit of these operations would leave no distance
    let [a, b] = an_ulp_apart::<6>(8);
    is_tight_to_its_value(hausdorff_at_vertices(&a, &b));
    let [a, b] = an_ulp_apart::<4>(12);
    is_tight_to_its_value(hausdorff_at_vertices(&a, &b));
}

fn is_tight_to_its_value<const D: usize>(distance: Option<Distance<D>>) {
    let distance = distance.expect("the bodies have few vertices");
    assert!(distance.value > 0.0 && distance.value < 1e-13, "{distance:?}");
    assert!(distance.upper <= distance.value.next_up(), "{distance:?}");
}

#[test]
fn bodies_without_directions_and_lines() {
    for method in Method::ALL {
        let point = body::<2>(&[[0.0; 2]; 5]);
        let reduced = method.reduce(&Problem::new(&point, 2).unwrap()).unwrap();
        assert!(contains(&reduced.body, &point) && contains(&point, &reduced.body), "{}", method.id());
        let line = body::<1>(&[[3.0], [-1.0], [0.5]]);
        let reduced = method.reduce(&Problem::new(&line, 1).unwrap()).unwrap();
        assert!(contains(&reduced.body, &line) && reduced.body.generators()[0][0].abs() < 4.5000001, "{}", method.id());
    }
}

#[test]
fn what_is_asked_for_is_checked() {
    let cube = body(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]]);
    assert_eq!(Problem::new(&cube, 2).unwrap_err(), ReductionError::TooFew { count: 2, needed: 3 });
    for epsilon in [0.0, 1.0, -0.5, f64::NAN, f64::INFINITY] {
        assert!(matches!(patches_within(&cube, epsilon, &mut ()), Err(ReductionError::BadEpsilon(_))));
    }
    assert!(matches!(patches_within(&cube, 1e-12, &mut ()), Err(ReductionError::TooManyPatches(_))));
    assert_eq!(Method::ALL.map(|method| Method::from_id(method.id())), Method::ALL.map(Some));
}

/// The lemma's constant in space: 3 (2 √2 / ε)² = 24 / ε² patches keep the distance below ε D(A).
#[test]
fn patches_keep_the_precision() {
    let count = |epsilon: f64| patch_count(3, epsilon) * epsilon * epsilon;
    assert!((24.0..25.0).contains(&count(0.01)), "{}", count(0.01));
    let generators: Vec<[f64; 3]> = (0..300)
        .map(|k| {
            let (sin, cos) = libm::sincos(2.4 * f64::from(k));
            let z = f64::from(k) / 300.0;
            [cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z]
        })
        .collect();
    let inner = body(&generators);
    let diameter = 2.0 * inner.support([0.0, 0.0, 1.0]).value();
    for epsilon in [0.5, 0.2, 0.1] {
        let reduced = patches_within(&inner, epsilon, &mut ()).unwrap();
        assert!(excess(&reduced.body, &inner, 0.01).upper <= epsilon * diameter);
    }
}
