//! Every method of the kernel against the exact twin, on all line families, each answer with its certificate verified.

use families::drawn::lines::{self, Instance};
use proptest::prelude::*;
use tests::kernel_twin::Exact;
use tests::runner::for_all;
use zonotope::interop::verifier::check_lad;
use zonotope::lad::{LadOutcome, LadProblem, Method, WeightedLine, brute_force};

const CASES: u32 = 300;
const LARGE_CASES: u32 = 24;

fn problem(instance: &Instance) -> LadProblem<'static> {
    let lines: Vec<WeightedLine> = instance
        .terms
        .iter()
        .map(|term| WeightedLine { normal: term.a, offset: term.b, weight: term.weight })
        .collect();
    LadProblem::new(&lines, instance.linear).expect("the families are finite and their weights not negative")
}

fn agrees(instance: Instance) -> Result<(), TestCaseError> {
    let problem = problem(&instance);
    let exact = Exact::from(&instance);
    let least = exact.least_value();

    let truth = brute_force::minimize(&problem);
    prop_assert_eq!(truth.as_ref().map(|truth| &truth.value), least.as_ref(), "brute_force");
    for point in truth.iter().flat_map(|truth| &truth.minimizers) {
        prop_assert_eq!(Some(&exact.value(point)), least.as_ref(), "brute_force");
        prop_assert_eq!(Some(exact.face_dimension(point)), truth.as_ref().map(|truth| truth.face_dimension));
    }

    for method in Method::ALL {
        let name = method.id();
        for seed in [1, 2] {
            let outcome = method.minimize(&problem, seed, &mut ());
            prop_assert_eq!(check_lad(&problem, &outcome).proof().map(drop), Ok(()), "{}", name);
            match (&outcome, &least) {
                (LadOutcome::Optimal(optimum), Some(least)) => {
                    let point = optimum.exact_point(&problem).expect("an optimum of this problem");
                    prop_assert_eq!(&exact.value(&point), least, "{}", name);
                    prop_assert_eq!(optimum.exact_value(&problem), Some(least.clone()), "{}", name);
                    prop_assert_eq!(optimum.face_dimension, exact.face_dimension(&point), "{}", name);
                }
                (LadOutcome::Unbounded { direction }, None) => {
                    let slope = exact.slope_at_infinity(&direction.clone().map(|value| value.to_rational()));
                    prop_assert!(slope < dashu_ratio::RBig::ZERO, "{}", name);
                }
                _ => prop_assert!(false, "{}: {:?}, but the least value is {:?}", name, outcome, least),
            }
        }
    }
    Ok(())
}

/// Instances too large for the twin: the certificates prove the answers, and the methods must agree.
fn methods_agree(instance: Instance) -> Result<(), TestCaseError> {
    let problem = problem(&instance);
    let answers = Method::FAST.map(|method| (method.id(), method.minimize(&problem, 3, &mut ())));
    for (name, outcome) in &answers {
        prop_assert_eq!(check_lad(&problem, outcome).proof().map(drop), Ok(()), "{}", name);
    }
    let face = |outcome: &LadOutcome| {
        outcome.optimum().and_then(|optimum| Some((optimum.exact_value(&problem)?, optimum.face_dimension)))
    };
    let (first_name, first) = &answers[0];
    for (name, outcome) in &answers[1..] {
        prop_assert_eq!(face(outcome), face(first), "{} and {}", name, first_name);
    }
    Ok(())
}

tests::test_on_line_families!(mod small: 1..=9, mixed 1..=6, CASES, agrees);
// beyond the size up to which pruning leaves the work to line searches
tests::test_on_line_families!(mod large: 51..=900, mixed 51..=900, LARGE_CASES, methods_agree);

#[test]
fn few_barely_bounded() {
    for_all(&lines::barely_bounded(1..=9), CASES, agrees);
}

#[test]
fn many_barely_bounded() {
    for_all(&lines::barely_bounded(51..=900), LARGE_CASES, methods_agree);
}
