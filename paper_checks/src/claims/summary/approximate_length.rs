//! Section 2, third bullet.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "summary-approximate-length",
    place: Place { section: "2", label: "third bullet" },
    kind: ClaimKind::Statement,
    statement: "A zonotope enclosing n points of R^d with total length within 1 + O(eps) of the least takes O(n \
        eps^(-(d-1)^2) + eps^(-O(d^2))) time",
    check: Check::Restates("theorem-4.7"),
    ..Claim::LISTED
};
