//! Section 2, first bullet.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "summary-min-area",
    place: Place { section: "2", label: "first bullet" },
    kind: ClaimKind::Statement,
    statement: "The minimum-area zonogon enclosing n points of the plane takes O(n log^2 n) time",
    figures: &["scaling-min-area-operations", "scaling-min-area-times"],
    check: Check::Restates("theorem-4.5"),
    ..Claim::LISTED
};
