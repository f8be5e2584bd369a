//! Section 4.3, Theorem 4.7.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-4.7",
    place: Place { section: "4.3", label: "Theorem 4.7" },
    kind: ClaimKind::Theorem,
    statement: "An enclosing zonotope with total length within O(eps) of the least can be computed in O(n eps^(-(d-1)^2) + eps^(-O(d^2))) time",
    ..Claim::LISTED
};
