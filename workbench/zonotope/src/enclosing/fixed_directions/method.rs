//! The registry of the methods in doubles, for callers that choose one by name.

use super::answer::Enclosure;
use super::by_row_generation;
use super::problem::{FixedDirections, FixedDirectionsError};
#[cfg(feature = "linear-programming")]
use super::{papers_program, support_form};
#[cfg(feature = "linear-programming")]
use crate::linear_program::Clarabel;
use crate::tables::methods;
use crate::tally::Tally;

methods! {
    /// A method whose answers contain the points exactly and prove their lower bounds.
    pub enum Method;
    /// The cost for n points and k directions in d dimensions.
    fn cost;

    /// [`by_row_generation`], the default.
    RowGeneration => "by_row_generation", "Normals as they are needed",
        "a few passes over the points, pivots of O((k + d)²)";
    /// `support_form`, with an engine for linear programs.
    #[cfg(feature = "linear-programming")]
    SupportForm => "support_form", "All normals",
        "O(n k^(d−1)), then a linear program of k + d unknowns and 2 C(k, d − 1) rows";
    /// `papers_program`, with an engine for linear programs.
    #[cfg(feature = "linear-programming")]
    PapersProgram => "papers_program", "The paper's program",
        "O(n k^(d−1)), then a linear program of k n' + k + d unknowns, n' the extreme points";
}

impl Method {
    /// The smallest zonotope along the directions around the points, counting operations.
    ///
    /// # Errors
    /// When a coefficient of the answer exceeds the largest double.
    #[inline(never)]
    pub fn solve<const D: usize>(
        self,
        problem: &FixedDirections<'_, D>,
        tally: &mut dyn Tally,
    ) -> Result<Enclosure<D>, FixedDirectionsError> {
        match self {
            Self::RowGeneration => by_row_generation::min_length_along(problem, tally),
            #[cfg(feature = "linear-programming")]
            Self::SupportForm => support_form::min_length_by_support_form(problem, &Clarabel, tally),
            #[cfg(feature = "linear-programming")]
            Self::PapersProgram => papers_program::min_length_by_papers_program(problem, &Clarabel, tally),
        }
    }
}
