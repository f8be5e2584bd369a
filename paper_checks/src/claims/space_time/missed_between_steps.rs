//! Section 6, first paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "collisions-between-steps",
    place: Place { section: "6", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "Tests at each time step alone may miss a collision, if P and Q overlap and stop overlapping within a \
        single step, and may be unnecessary when they are far away",
    ..Claim::LISTED
};
