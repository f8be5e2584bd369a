//! Section 1, first bullet.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-1-difference",
    place: Place { section: "1", label: "first bullet" },
    kind: ClaimKind::Erratum,
    statement: "Zonotopes are closed under Minkowski difference",
    remedy: Some("true of A + (-B), false of the erosion { x : x + B in A } when d > 2: use two names"),
    ..Claim::LISTED
};
