//! Section 4.1, Theorem 4.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-4.5",
    place: Place { section: "4.1", label: "Theorem 4.5" },
    kind: ClaimKind::Theorem,
    statement: "The minimum-area zonotope containing n points of the plane can be computed in O(n log^2 n) time",
    ..Claim::LISTED
};
