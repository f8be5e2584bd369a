//! The answer of the method: a proof that an engine's optimum gave, or the reason why it gave none.

use crate::linear_program::Guess;
use crate::zonotope::location::{Location, Witness};

/// The statement that an engine's optimum proves.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer<const D: usize> {
    /// The place of the displacement.
    Located(Location<D>),
    /// The displacement lies in the zonotope; inside or on the boundary was not decided.
    Member(Witness),
    /// Nothing was proved.
    Undecided(Undecided),
}

/// Why nothing was proved.
#[derive(Debug, Clone, PartialEq)]
pub enum Undecided {
    /// The engine found no optimum, although there is one.
    Engine(Guess),
    /// Neither the primal nor the dual values of the optimum became a proof.
    Unproved {
        /// The gauge by the engine: what a caller who believes it would compare with 1.
        believed_gauge: f64,
    },
}

impl<const D: usize> Answer<D> {
    /// The location, if it was decided completely.
    pub fn location(&self) -> Option<&Location<D>> {
        match self {
            Self::Located(location) => Some(location),
            _ => None,
        }
    }

    /// Whether the displacement lies in the zonotope, if that was proved.
    pub fn is_member(&self) -> Option<bool> {
        match self {
            Self::Located(location) => Some(location.is_member()),
            Self::Member(_) => Some(true),
            Self::Undecided(_) => None,
        }
    }
}
