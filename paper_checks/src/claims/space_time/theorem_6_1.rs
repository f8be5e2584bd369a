//! Section 6, Theorem 6.1.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-6.1",
    place: Place { section: "6", label: "Theorem 6.1" },
    kind: ClaimKind::Theorem,
    statement: "Three generators added to P, computed in O(n log n) time, give a zonotope that bounds all placements \
        of P during a rigid motion",
    ..Claim::LISTED
};
