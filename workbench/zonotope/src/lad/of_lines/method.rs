//! The methods of the kernel by name.

use super::input::LadProblem;
use super::optimum::LadOutcome;
use super::{by_line_search, by_pruning, by_slope_selection};
use crate::tally::Tally;

/// A method that solves any problem of the kernel exactly.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_line_search`].
    LineSearch,
    /// [`by_slope_selection`], the paper's search.
    SlopeSelection,
    /// [`by_pruning`], the default.
    #[default]
    Pruning,
}

impl Method {
    /// Every method.
    pub const ALL: [Self; 3] = [Self::LineSearch, Self::SlopeSelection, Self::Pruning];

    /// The name of the method's file.
    pub fn name(self) -> &'static str {
        match self {
            Self::LineSearch => "by_line_search",
            Self::SlopeSelection => "by_slope_selection",
            Self::Pruning => "by_pruning",
        }
    }

    /// The method of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// Minimises a problem by this method. `seed` decides the time, never the minimum.
    pub fn minimize(self, problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> LadOutcome {
        match self {
            Self::LineSearch => by_line_search::minimize_counted(problem, seed, tally),
            Self::SlopeSelection => by_slope_selection::minimize_counted(problem, seed, tally),
            Self::Pruning => by_pruning::minimize_counted(problem, seed, tally),
        }
    }
}
