//! Section 6, Figure 3.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "figure-3",
    place: Place { section: "6", label: "Figure 3" },
    kind: ClaimKind::Figure,
    statement: "The arcs of the vertices of a rotating body, moved to a common origin, and the parallelogram around \
        them",
    ..Claim::LISTED
};
