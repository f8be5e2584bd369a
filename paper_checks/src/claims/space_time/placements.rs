//! Section 6, fourth paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "placements-by-vertices",
    place: Place { section: "6", label: "fourth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The volume contains all vertices of each placement of P during the rotation, and so, by convexity, \
        all of P throughout the interval",
    ..Claim::LISTED
};
