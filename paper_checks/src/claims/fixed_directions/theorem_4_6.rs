//! Section 4.2, Theorem 4.6.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-4.6",
    place: Place { section: "4.2", label: "Theorem 4.6" },
    kind: ClaimKind::Theorem,
    statement: "The discrete oriented zonotope of least total length along k directions containing n points can be computed in O(n k^(d-1) + k^O(d)) time",
    ..Claim::LISTED
};
