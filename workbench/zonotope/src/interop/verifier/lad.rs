//! Optima of least absolute deviations.

use ::verifier::{Fraction, Lad, LadAnswer, LadProof, Verdict};
use dashu_int::IBig;

use super::fraction;
use crate::arrangement::{ExactLine, LineIndex};
use crate::lad::of_forms::{SpaceLadProblem, SpaceOutcome};
use crate::lad::{LadOptimum, LadOutcome, LadProblem};
use crate::numeric::dyadic::Dyadic;

/// Checks the outcome of a problem by lines, but for the dimension of the set of minimisers. O(n) exact operations.
pub fn check_lad(problem: &LadProblem, outcome: &LadOutcome) -> Verdict<LadProof> {
    match lad_answer(problem, outcome) {
        Ok(answer) => ::verifier::check_lad(&lad_of_lines(problem), &answer),
        Err(reason) => Verdict::Wrong(reason),
    }
}

/// The problem in whole numbers of one unit, which changes neither minimisers nor directions.
fn lad_of_lines(problem: &LadProblem) -> Lad<2> {
    let linear = problem.exact_linear();
    let lines: Vec<ExactLine> = (0..problem.len() as u32).map(|line| problem.exact_line(LineIndex(line))).collect();
    let numbers = lines.iter().flat_map(|line| line.normal.iter().chain([&line.offset])).chain(&linear);
    let unit = numbers.filter(|number| !number.is_zero()).map(Dyadic::exponent).min().unwrap_or(0);
    let terms =
        lines.iter().map(|ExactLine { normal, offset }| (normal.each_ref().map(|c| c.units(unit)), offset.units(unit)));
    Lad::of_whole_numbers(linear.map(|c| c.units(unit)), terms.collect())
}

/// The outcome as the verifier takes it, without a value, which an optimum by lines does not claim.
///
/// # Errors
/// A sentence about an optimum of another problem: its minimiser names lines that this one does not have, or that do
/// not meet here.
pub fn lad_answer(problem: &LadProblem, outcome: &LadOutcome) -> Result<LadAnswer<2>, String> {
    match outcome {
        LadOutcome::Optimal(optimum) => written(problem, optimum),
        LadOutcome::Unbounded { direction } => {
            Ok(LadAnswer::Unbounded { direction: direction.each_ref().map(|c| fraction(&c.to_rational())) })
        }
    }
}

fn written(problem: &LadProblem, optimum: &LadOptimum) -> Result<LadAnswer<2>, String> {
    let point = optimum.homogeneous_point(problem).ok_or("the minimiser is not one of this problem")?;
    let unit = point.iter().filter(|number| !number.is_zero()).map(Dyadic::exponent).min().unwrap_or(0);
    let [x, y, w]: [IBig; 3] = point.map(|number| number.units(unit));
    let [x, y] = [x, y].map(|c| Fraction::new(c, w.clone()).expect("the third coordinate is positive"));
    let basis = optimum.certificate.basis.iter().map(|line| line.position()).collect();
    Ok(LadAnswer::Optimal { point: [x, y], value: None, signs: optimum.certificate.signs.clone(), basis })
}

/// Checks the outcome of a problem in three variables. O(n) exact operations.
pub fn check_lad_of_forms(problem: &SpaceLadProblem, outcome: &SpaceOutcome) -> Verdict<LadProof> {
    let terms: Vec<([f64; 3], f64, f64)> =
        problem.planes().iter().map(|plane| (plane.normal, plane.offset, plane.weight)).collect();
    let question = Lad::new(problem.linear(), &terms).expect("a problem is finite and has no negative weight");
    ::verifier::check_lad(&question, &lad_of_forms_answer(outcome))
}

/// The outcome as the verifier takes it.
pub fn lad_of_forms_answer(outcome: &SpaceOutcome) -> LadAnswer<3> {
    match outcome {
        SpaceOutcome::Optimal(optimum) => LadAnswer::Optimal {
            point: optimum.point.each_ref().map(fraction),
            value: Some(fraction(&optimum.value)),
            signs: optimum.certificate.signs.clone(),
            basis: optimum.certificate.basis.iter().map(|&plane| plane as usize).collect(),
        },
        SpaceOutcome::Unbounded { direction } => LadAnswer::Unbounded { direction: direction.each_ref().map(fraction) },
    }
}
