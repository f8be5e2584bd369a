//! Section 2, fourth bullet.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "summary-intersection",
    place: Place { section: "2", label: "fourth bullet" },
    kind: ClaimKind::Statement,
    statement: "Whether two zonotopes of R^3 with n generators in total intersect is decided in O(n log^2 n) time",
    check: Check::Restates("theorem-5.2"),
    ..Claim::LISTED
};
