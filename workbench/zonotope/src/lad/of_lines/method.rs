//! The methods of the kernel in the plane, by name.

use super::input::LadProblem;
use super::optimum::LadOutcome;
use super::{brute_force, by_line_search, by_pruning, by_slope_selection};
use crate::tally::Tally;

/// A method that solves any problem of the kernel exactly.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// The truth in exact rationals, [`brute_force`], for a few dozen lines.
    BruteForce,
    /// Exact line searches from vertex to vertex, [`by_line_search`].
    LineSearch,
    /// The paper's search, [`by_slope_selection`].
    SlopeSelection,
    /// The default, [`by_pruning`].
    #[default]
    Pruning,
}

impl Method {
    /// Every method.
    pub const ALL: [Self; 4] = [Self::BruteForce, Self::LineSearch, Self::SlopeSelection, Self::Pruning];

    /// The methods whose cost allows any number of lines.
    pub const FAST: [Self; 3] = [Self::LineSearch, Self::SlopeSelection, Self::Pruning];

    /// The name of the method's file, by which experiments and questions name the method.
    pub const fn id(self) -> &'static str {
        match self {
            Self::BruteForce => "brute_force",
            Self::LineSearch => "by_line_search",
            Self::SlopeSelection => "by_slope_selection",
            Self::Pruning => "by_pruning",
        }
    }

    /// The method in a few words.
    pub const fn title(self) -> &'static str {
        match self {
            Self::BruteForce => "All vertices, in exact rationals",
            Self::LineSearch => "Line searches",
            Self::SlopeSelection => "Slope selection (the paper's search)",
            Self::Pruning => "Pruning",
        }
    }

    /// The method's cost for n lines.
    pub fn cost(self) -> &'static str {
        match self {
            Self::BruteForce => "O(n^3) exact operations",
            Self::LineSearch => "O(n) a line search, few searches",
            Self::SlopeSelection => "O(n log^2 n) expected",
            Self::Pruning => "O(n) expected",
        }
    }

    /// The method of an id.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// Minimises a problem by this method. `seed` decides the time, never the minimum; the truth counts no operations.
    pub fn minimize(self, problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> LadOutcome {
        match self {
            Self::BruteForce => brute_force::solve(problem),
            Self::LineSearch => by_line_search::minimize_counted(problem, seed, tally),
            Self::SlopeSelection => by_slope_selection::minimize_counted(problem, seed, tally),
            Self::Pruning => by_pruning::minimize_counted(problem, seed, tally),
        }
    }
}
