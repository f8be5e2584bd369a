//! Weighted least absolute deviations in the plane, by exact line searches from vertex to vertex.
//!
//! # Source
//! Bloomfield and Steiger, Least Absolute Deviations (1983): descend along the lines of the arrangement, each time to
//! the weighted median of the crossings. Departures: floating point only proposes the median, and an exact pass proves
//! it or says on which side to go on; where many lines meet, the lines through the vertex are moved apart at random and
//! solved as a kernel problem of their own, which makes the method finite on degenerate input.
//!
//! # Method
//! 1. Search along the first line for its exact minimum.
//! 2. At the vertex found, take the exact slopes along the lines through it. If none is negative, the vertex is a
//!    minimiser and the signs of all lines there are its certificate.
//! 3. Else search along a line with a negative slope, and go on with 2: the objective strictly falls.
//!
//! # Complexity
//! n lines: expected O(n) a line search; the number of line searches has no better proven bound than the number of
//! vertices, O(n²), and is observed to grow like log n. Space O(n).
//!
//! # Numerics
//! Every sign (side of a line, slope, parallelism) is exact: filtered floating point, then exact dyadic arithmetic.
//!
//! # Example
//! ```
//! use zonotope::lad::{LadProblem, WeightedLine, by_line_search};
//! // |x − 1| + |y − 2| + |x + y| ≥ (1 − x) + (2 − y) + (x + y) = 3, with equality at (1, 2)
//! let lines = [([1.0, 0.0], -1.0), ([0.0, 1.0], -2.0), ([1.0, 1.0], 0.0)];
//! let lines = lines.map(|(normal, offset)| WeightedLine::unweighted(normal, offset));
//! let problem = LadProblem::new(&lines, [0.0, 0.0]).unwrap();
//! let outcome = by_line_search::minimize(&problem, 0, &mut ());
//! let value = outcome.optimum().unwrap().exact_value(&problem).expect("it is that of this problem");
//! assert_eq!(value, 3.into());
//! ```

use super::by_pruning::tie_break;
use super::descent::{SearchLine, descend, solve_with};
use super::input::LadProblem;
use super::optimum::LadOutcome;
use super::subproblem::Subproblem;
use crate::tally::Tally;

/// Minimises a problem by line searches. `seed` only decides how lines through one vertex are moved apart.
pub fn minimize(problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> LadOutcome {
    let subproblem = Subproblem::whole(problem);
    let ties = tie_break(seed);
    let solution = solve_with(&subproblem, &ties, tally, |first, tally| {
        descend(&subproblem, SearchLine::of(&subproblem, first), &ties, tally)
    });
    LadOutcome::new(solution)
}
