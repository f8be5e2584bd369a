//! The kernel's methods by name, and its instances, for every experiment on it.

use crate::definition::Case;
use crate::families::lines::LineRow;
use crate::seed::Digest;
use zonotope::lad::{LadOutcome, LadProblem, WeightedLine, by_line_search, by_pruning};
use zonotope::tally::Tally;

/// The case's lines, unweighted, without a linear term.
pub(super) fn problem(case: &Case) -> Result<LadProblem<'static>, String> {
    let lines: Vec<WeightedLine> =
        case.lines()?.into_iter().map(|(normal, offset): LineRow| WeightedLine::unweighted(normal, offset)).collect();
    LadProblem::new(&lines, [0.0, 0.0]).map_err(|error| error.to_string())
}

/// Runs the method that the case's variant names, with the case's seed.
pub(super) fn minimize(case: &Case, problem: &LadProblem, tally: &mut impl Tally) -> Result<LadOutcome, String> {
    match case.variant {
        "by_line_search" => Ok(by_line_search::minimize_counted(problem, case.seed, tally)),
        "by_pruning" => Ok(by_pruning::minimize_counted(problem, case.seed, tally)),
        other => Err(format!("no method is called {other}")),
    }
}

/// A hash of the minimiser, rounded, and of the dimension of the set of minimisers.
pub(super) fn digest(problem: &LadProblem, outcome: &LadOutcome) -> u64 {
    match outcome {
        LadOutcome::Optimal(optimum) => {
            Digest::default().floats(&optimum.point(problem)).word(u64::from(optimum.face_dimension)).finish()
        }
        LadOutcome::Unbounded { direction } => {
            Digest::default().bytes(b"unbounded").floats(&[direction[0].to_f64(), direction[1].to_f64()]).finish()
        }
    }
}
