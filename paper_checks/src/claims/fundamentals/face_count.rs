//! Section 3, first paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "face-count",
    place: Place { section: "3", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "In R^d a zonotope with n generators has complexity O(n^(d-1)), and the topology of its boundary is that of an arrangement",
    ..Claim::LISTED
};
