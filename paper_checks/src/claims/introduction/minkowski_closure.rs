//! Section 1, first bullet.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "minkowski-closure",
    place: Place { section: "1", label: "first bullet" },
    kind: ClaimKind::Statement,
    statement: "Zonotopes are closed under Minkowski sum and difference, so intersection reduces to membership of a point",
    ..Claim::LISTED
};
