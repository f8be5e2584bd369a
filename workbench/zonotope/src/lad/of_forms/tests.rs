//! The line search against the truth, on every family of planes.

use families::drawn::numbers::{extreme_scale, integer};
use proptest::prelude::*;

use super::*;
use crate::interop::verifier::check_lad_of_forms;

fn check(planes: Vec<WeightedPlane>, linear: [f64; 3]) -> Result<(), TestCaseError> {
    let problem = SpaceLadProblem::new(planes, linear).expect("the family makes finite planes");
    let outcome = minimize(&problem, &mut ());
    prop_assert_eq!(check_lad_of_forms(&problem, &outcome).proof().map(drop), Ok(()), "{:?}", outcome);
    let value = match outcome {
        SpaceOutcome::Optimal(optimum) => Some(optimum.value),
        SpaceOutcome::Unbounded { .. } => None,
    };
    prop_assert_eq!(value, brute_force::minimum(&problem));
    Ok(())
}

fn planes(coefficient: impl Strategy<Value = f64> + Clone, count: usize) -> impl Strategy<Value = Vec<WeightedPlane>> {
    let weight = prop_oneof![4 => Just(1.0), 1 => Just(0.0), 2 => 0.1..3.0f64];
    let number = move || coefficient.clone();
    let plane = ([number(), number(), number()], number(), weight).prop_map(|(normal, offset, weight)| WeightedPlane {
        normal,
        offset,
        weight,
    });
    proptest::collection::vec(plane, 0..count)
}

fn linear() -> impl Strategy<Value = [f64; 3]> {
    let of = |number: BoxedStrategy<f64>| [number.clone(), number.clone(), number];
    prop_oneof![3 => Just([0.0; 3]), 1 => of(integer(2).boxed()), 1 => of((-2.0..2.0f64).boxed())]
}

properties! {
    #![proptest_config(crate::property_cases::config(250))]

    #[test]
    fn random_planes(planes in planes(-1.0..1.0f64, 9), linear in linear()) {
        check(planes, linear)?;
    }

    #[test]
    fn lattice_planes(planes in planes(integer(2), 10), linear in linear()) {
        check(planes, linear)?;
    }

    #[test]
    fn planes_of_all_magnitudes(
        planes in planes((integer(2), extreme_scale()).prop_map(|(v, s)| v * s), 7),
        linear in linear(),
    ) {
        check(planes, linear)?;
    }

    #[test]
    fn concurrent_planes(
        planes in planes(integer(2), 10),
        apex in [integer(2), integer(2), integer(2)],
        linear in linear(),
    ) {
        let planes = planes
            .into_iter()
            .map(|plane| {
                let at: f64 = plane.normal.iter().zip(apex).map(|(a, x)| a * x).sum();
                WeightedPlane { offset: -at, ..plane }
            })
            .collect();
        check(planes, linear)?;
    }

    #[test]
    fn nearly_parallel_planes(planes in planes(integer(2), 8), ulps in proptest::collection::vec(-2i64..3, 8)) {
        let nudge = |v: f64, by: i64| f64::from_bits((v.to_bits() as i64 + by) as u64);
        let planes = planes
            .into_iter()
            .zip(ulps)
            .map(|(plane, by)| WeightedPlane {
                normal: [nudge(1.0, by) + plane.normal[0] * 1e-13, 1.0, plane.normal[2] * 1e-300],
                offset: nudge(1.0, -by),
                weight: plane.weight,
            })
            .collect();
        check(planes, [0.0; 3])?;
    }

    #[test]
    fn flat_families(planes in planes(integer(2), 10), linear in linear()) {
        let flat =
            planes.into_iter().map(|plane| WeightedPlane { normal: [plane.normal[0], plane.normal[1], 0.0], ..plane });
        check(flat.collect(), [linear[0], linear[1], 0.0])?;
    }
}

#[test]
fn large_instances_are_solved_and_verified() {
    use rand::{RngExt, SeedableRng};
    let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(7);
    for is_lattice in [false, true] {
        let planes: Vec<_> = (0..3000)
            .map(|_| {
                let mut value =
                    || if is_lattice { f64::from(random.random_range(-3..4)) } else { random.random_range(-1.0..1.0) };
                WeightedPlane { normal: [value(), value(), value()], offset: value(), weight: 1.0 }
            })
            .collect();
        let problem = SpaceLadProblem::new(planes, [3.0, -20.0, 1.5]).expect("finite planes");
        let mut counts = crate::tally::OperationCounts::default();
        let outcome = minimize(&problem, &mut counts);
        assert_eq!(check_lad_of_forms(&problem, &outcome).proof().map(drop), Ok(()));
        let passes = counts.get(crate::tally::Operation::LineEvaluation) / 3000;
        assert!(passes < 100, "{counts:?}");
    }
}
