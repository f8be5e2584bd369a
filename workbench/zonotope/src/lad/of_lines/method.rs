//! The methods of the kernel in the plane, by name.

use super::input::LadProblem;
use super::optimum::LadOutcome;
use super::{brute_force, by_line_search, by_pruning, by_slope_selection};
use crate::tables::methods;
use crate::tally::Tally;

methods! {
    /// A method that solves any problem of the kernel exactly.
    pub enum Method;
    /// The method's cost for n lines.
    fn cost;

    /// The default, [`by_pruning`].
    Pruning => "by_pruning", "Pruning", "O(n) expected";
    /// The paper's search, [`by_slope_selection`].
    SlopeSelection => "by_slope_selection", "Slope selection (the paper's search)", "O(n log^2 n) expected";
    /// Exact line searches from vertex to vertex, [`by_line_search`].
    LineSearch => "by_line_search", "Line searches", "O(n) a line search, few searches";
    /// The truth in exact rationals, [`brute_force`], for a few dozen lines.
    BruteForce => "brute_force", "All vertices, in exact rationals", "O(n^3) exact operations";
}

impl Method {
    /// The methods whose cost allows any number of lines.
    pub const FAST: [Self; 3] = [Self::LineSearch, Self::SlopeSelection, Self::Pruning];

    /// Minimises a problem by this method. `seed` decides the time, never the minimum; the truth counts no operations.
    pub fn minimize(self, problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> LadOutcome {
        match self {
            Self::BruteForce => brute_force::solve(problem),
            Self::LineSearch => by_line_search::minimize(problem, seed, tally),
            Self::SlopeSelection => by_slope_selection::minimize(problem, seed, tally),
            Self::Pruning => by_pruning::minimize(problem, seed, tally),
        }
    }
}
