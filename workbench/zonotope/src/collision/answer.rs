//! The answer of the ladder of a location: where the displacement lies, and the rung that proved it.

use super::{Location, Separation, Witness};
use crate::tally::{Rung, Tally};

/// A location with its proof, and the rung by which the proof was found.
#[derive(Debug, Clone)]
pub(crate) struct Proof {
    pub(crate) location: Location<3>,
    pub(crate) rung: Rung,
}

impl Proof {
    /// The proof of a displacement in the interior.
    pub(crate) fn inside(witness: Witness, rung: Rung) -> Self {
        Self { location: Location::Inside(witness), rung }
    }

    /// The proof of a member that is not in the interior.
    pub(crate) fn boundary(witness: Witness, rung: Rung) -> Self {
        Self { location: Location::Boundary(witness), rung }
    }

    /// The proof by a direction of doubles that separates.
    pub(crate) fn outside(direction: [f64; 3], rung: Rung) -> Self {
        Self { location: Location::Outside(Separation::Rounded(direction)), rung }
    }

    /// The direction of doubles that separates, if that is the proof.
    pub(crate) fn direction(&self) -> Option<[f64; 3]> {
        match self.location {
            Location::Outside(Separation::Rounded(direction)) => Some(direction),
            _ => None,
        }
    }

    /// The location, its rung counted. The rung of a displacement of zero has been counted by the search that ended
    /// there.
    pub(crate) fn counted(self, tally: &mut dyn Tally) -> Location<3> {
        if self.rung != Rung::ZeroDisplacement {
            tally.answered_by(self.rung);
        }
        self.location
    }
}
