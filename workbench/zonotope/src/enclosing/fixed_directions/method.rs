//! The registry of the methods in doubles, for callers that choose one by name.

use super::answer::Enclosure;
use super::by_row_generation;
use super::problem::{FixedDirections, FixedDirectionsError};
#[cfg(feature = "linear-programming")]
use super::{papers_program, support_form};
#[cfg(feature = "linear-programming")]
use crate::linear_program::Clarabel;
use crate::tally::Tally;

/// A method whose answers contain the points exactly and prove their lower bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_row_generation`], the default.
    #[default]
    RowGeneration,
    /// `support_form`, with an engine for linear programs.
    #[cfg(feature = "linear-programming")]
    SupportForm,
    /// `papers_program`, with an engine for linear programs.
    #[cfg(feature = "linear-programming")]
    PapersProgram,
}

impl Method {
    /// Every method of this build, the default first.
    #[cfg(feature = "linear-programming")]
    pub const ALL: [Self; 3] = [Self::RowGeneration, Self::SupportForm, Self::PapersProgram];

    /// Every method of this build.
    #[cfg(not(feature = "linear-programming"))]
    pub const ALL: [Self; 1] = [Self::RowGeneration];

    /// The name of the method's module.
    pub const fn id(self) -> &'static str {
        match self {
            Self::RowGeneration => "by_row_generation",
            #[cfg(feature = "linear-programming")]
            Self::SupportForm => "support_form",
            #[cfg(feature = "linear-programming")]
            Self::PapersProgram => "papers_program",
        }
    }

    /// The method of an id.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The method in a few words.
    pub const fn title(self) -> &'static str {
        match self {
            Self::RowGeneration => "Normals as they are needed",
            #[cfg(feature = "linear-programming")]
            Self::SupportForm => "All normals",
            #[cfg(feature = "linear-programming")]
            Self::PapersProgram => "The paper's program",
        }
    }

    /// The cost for n points and k directions in d dimensions.
    pub fn cost(self) -> &'static str {
        match self {
            Self::RowGeneration => "a few passes over the points, pivots of O((k + d)²)",
            #[cfg(feature = "linear-programming")]
            Self::SupportForm => "O(n k^(d−1)), then a linear program of k + d unknowns and 2 C(k, d − 1) rows",
            #[cfg(feature = "linear-programming")]
            Self::PapersProgram => {
                "O(n k^(d−1)), then a linear program of k n' + k + d unknowns, n' the extreme points"
            }
        }
    }

    /// Whether the method works in a dimension: every method works in every dimension from 1 on.
    pub fn works_in(self, dimension: usize) -> bool {
        dimension >= 1
    }

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
            Self::RowGeneration => by_row_generation::min_length_along_counted(problem, tally),
            #[cfg(feature = "linear-programming")]
            Self::SupportForm => support_form::min_length_by_support_form_counted(problem, &Clarabel, tally),
            #[cfg(feature = "linear-programming")]
            Self::PapersProgram => papers_program::min_length_by_papers_program_counted(problem, &Clarabel, tally),
        }
    }
}
