//! Every method against the truth, on every family of lines.

use families::drawn::numbers::{extreme_scale, integer};
use proptest::prelude::*;

use super::*;
use crate::interop::verifier::check_lad;
use crate::numeric::Rational;

fn check(lines: &[WeightedLine], linear: [f64; 2]) -> Result<(), TestCaseError> {
    let problem = LadProblem::new(lines, linear).expect("the family makes finite lines");
    let truth = brute_force::minimize(&problem);
    for method in Method::ALL {
        check_outcome(method.id(), &problem, &truth, method.minimize(&problem, 1, &mut ()))?;
    }
    // So few lines are pruned as well here, which the method itself leaves to line searches.
    for small in [2, 5] {
        check_outcome("by_pruning", &problem, &truth, by_pruning::minimize_above(small, &problem, 1))?;
    }
    Ok(())
}

fn check_outcome(
    name: &str,
    problem: &LadProblem,
    truth: &Option<brute_force::Truth>,
    outcome: LadOutcome,
) -> Result<(), TestCaseError> {
    let verdict = check_lad(problem, &outcome);
    prop_assert!(verdict.is_right(), "{}: {:?} of {:?}", name, verdict, outcome);
    let Some(truth) = truth else {
        prop_assert!(outcome.optimum().is_none(), "{} misses that the problem is unbounded", name);
        return Ok(());
    };
    let optimum = outcome.optimum();
    prop_assert!(optimum.is_some(), "{} says unbounded", name);
    let optimum = optimum.expect("just seen");
    prop_assert_eq!(optimum.exact_value(problem), Some(truth.value.clone()), "{}", name);
    prop_assert_eq!(optimum.face_dimension, truth.face_dimension, "{}: {:?} {:?}", name, optimum, truth);
    if let Minimizer::Vertex(..) = optimum.minimizer {
        let point = optimum.exact_point(problem).expect("an optimum of this problem");
        prop_assert!(truth.minimizers.contains(&point), "{}", name);
    }
    Ok(())
}

fn line(coefficient: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = WeightedLine> {
    let weight = prop_oneof![4 => Just(1.0), 1 => Just(0.0), 2 => 0.1..3.0f64, 1 => extreme_scale()];
    (coefficient.clone(), coefficient.clone(), coefficient, weight).prop_map(|(x, y, offset, weight)| WeightedLine {
        normal: [x, y],
        offset,
        weight,
    })
}

fn lines(coefficient: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vec<WeightedLine>> {
    proptest::collection::vec(line(coefficient), 0..13)
}

fn linear() -> impl Strategy<Value = [f64; 2]> {
    prop_oneof![3 => Just([0.0, 0.0]), 1 => [integer(2), integer(2)], 1 => [-3.0..3.0f64, -3.0..3.0]]
}

properties! {
    #![proptest_config(crate::property_cases::config(1500))]

    #[test]
    fn random_lines(lines in lines(-1.0..1.0f64), linear in linear()) {
        check(&lines, linear)?;
    }

    #[test]
    fn lattice_lines(lines in lines(integer(2)), linear in linear()) {
        check(&lines, linear)?;
    }

    #[test]
    fn lines_of_all_magnitudes(
        lines in lines((integer(2), extreme_scale()).prop_map(|(v, s)| v * s)), linear in linear()
    ) {
        check(&lines, linear)?;
    }

    #[test]
    fn lines_of_one_magnitude(lines in lines(-1.0..1.0f64), s in extreme_scale(), linear in linear()) {
        let lines: Vec<_> = lines
            .into_iter()
            .map(|l| WeightedLine { normal: l.normal.map(|v| v * s), offset: l.offset * s, weight: l.weight.min(2.0) })
            .collect();
        check(&lines, linear.map(|v| v * s))?;
    }

    #[test]
    fn nearly_parallel_lines(lines in lines(integer(2)), ulps in proptest::collection::vec(-2i64..3, 13)) {
        let nudge = |v: f64, by: i64| f64::from_bits((v.to_bits() as i64 + by) as u64);
        let lines: Vec<_> = lines
            .iter()
            .zip(ulps)
            .map(|(l, by)| WeightedLine {
                normal: [nudge(1.0, by) + l.normal[0] * 1e-12, 1.0],
                offset: nudge(1.0, -by),
                weight: l.weight,
            })
            .collect();
        check(&lines, [0.0, 0.0])?;
    }

    #[test]
    fn concurrent_lines(lines in lines(integer(2)), apart in integer(2)) {
        let lines: Vec<_> = lines
            .iter()
            .map(|l| WeightedLine { offset: -(l.normal[0] * 3.0 + l.normal[1] * apart), ..*l })
            .collect();
        check(&lines, [1.0, 0.0])?;
    }
}

#[test]
fn large_instances_are_pruned_and_verified() {
    use rand::{RngExt, SeedableRng};
    let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(3);
    let lines: Vec<_> = (0..20_000)
        .map(|_| {
            let mut value = || random.random_range(-1.0..1.0);
            WeightedLine::unweighted([value(), value()], value())
        })
        .collect();
    let problem = LadProblem::new(&lines, [3.0, -40.0]).expect("finite lines");
    let mut values: Vec<Option<Rational>> = Vec::new();
    for method in Method::FAST {
        let outcome = method.minimize(&problem, 5, &mut ());
        assert_eq!(check_lad(&problem, &outcome).proof().map(drop), Ok(()));
        values.push(outcome.optimum().expect("bounded").exact_value(&problem));
    }
    assert!(values.windows(2).all(|pair| pair[0] == pair[1]));
}

/// Pruning this far starts from a sample whose lines are all parallel: its optimum is on lines of the problem, but
/// where none cross.
#[test]
fn the_optimum_of_parallel_samples_is_no_vertex() {
    let line = |normal, offset, weight| WeightedLine { normal, offset, weight };
    let lines = [
        line([-1.0, -1.0], -1.0, 1.0),
        line([-2.0, 0.0], 0.0, 1.0),
        line([2.0, 2.0], 0.0, 1e150),
        line([1.0, -1.0], 1.0, 1.0),
        line([-2.0, -2.0], -2.0, 0.1),
    ];
    check(&lines, [0.0, 0.0]).expect("all methods agree with the truth");
}

/// A certificate may come from anywhere: names of lines that are not there, signs that are none, bases too long are
/// told, not indexed.
#[test]
fn changed_outcomes_are_refused_without_a_panic() {
    use crate::arrangement::LineIndex;
    let lines = [([1.0, 0.0], -1.0), ([0.0, 1.0], -2.0), ([1.0, 1.0], 0.0)];
    let lines = lines.map(|(normal, offset)| WeightedLine::unweighted(normal, offset));
    let problem = LadProblem::new(&lines, [0.0, 0.0]).expect("finite lines");
    let outcome = minimize(&problem, 1, &mut ());
    assert_eq!(check_lad(&problem, &outcome).proof().map(drop), Ok(()));
    let optimum = outcome.into_optimum().expect("bounded");
    let foreign = LineIndex(3);
    let refused = |change: &dyn Fn(&mut LadOptimum)| {
        let mut changed = optimum.clone();
        change(&mut changed);
        check_lad(&problem, &LadOutcome::Optimal(changed)).proof().expect_err("the certificate is wrong")
    };
    let foreign_lines: [&dyn Fn(&mut LadOptimum); 3] = [
        &|optimum| optimum.minimizer = Minimizer::Vertex(LineIndex(0), foreign),
        &|optimum| optimum.minimizer = Minimizer::Line(foreign),
        &|optimum| optimum.minimizer = Minimizer::Vertex(LineIndex(1), LineIndex(1)),
    ];
    for change in foreign_lines {
        assert!(refused(change).contains("not one of this problem"));
    }
    refused(&|optimum| optimum.certificate.basis.push(foreign));
    refused(&|optimum| optimum.certificate.signs[0] = i8::MIN);
    refused(&|optimum| optimum.certificate.signs.push(1));
    refused(&|optimum| optimum.certificate.basis = vec![LineIndex(0); 3]);
    refused(&|optimum| optimum.certificate.basis.clear());
    // The outcome of this problem is none of a problem with fewer lines.
    let fewer = LadProblem::new(&lines[..1], [0.0, 0.0]).expect("finite lines");
    assert!(check_lad(&fewer, &LadOutcome::Optimal(optimum.clone())).is_wrong());
}

#[test]
fn an_optimum_of_another_problem_has_no_point() {
    let line = |x: f64, y: f64, offset: f64| WeightedLine::unweighted([x, y], offset);
    let problem = |lines: &[WeightedLine]| LadProblem::new(lines, [0.0, 0.0]).expect("finite lines");
    let crossing = problem(&[line(1.0, 0.0, -1.0), line(0.0, 1.0, -2.0)]);
    let outcome = Method::default().minimize(&crossing, 0, &mut ());
    let optimum = outcome.optimum().expect("bounded");
    assert_eq!(optimum.point(&crossing), Some([1.0, 2.0]));
    for other in [problem(&[line(1.0, 0.0, 0.0)]), problem(&[line(1.0, 0.0, 0.0), line(2.0, 0.0, 1.0)])] {
        assert_eq!((optimum.point(&other), optimum.exact_value(&other)), (None, None));
        assert_eq!((optimum.exact_point(&other), optimum.homogeneous_point(&other)), (None, None));
    }
}
