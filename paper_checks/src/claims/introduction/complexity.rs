//! Section 1, fourth paragraph.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "complexity-bound",
    place: Place { section: "1", label: "fourth paragraph" },
    kind: ClaimKind::Statement,
    statement: "A zonotope in R^d has O(n^(d-1)) faces, and a zonohedron may have of order n^2",
    check: Check::Restates("face-count"),
    ..Claim::LISTED
};
