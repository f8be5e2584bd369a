//! Section 5.1, Theorem 5.2.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-5.2",
    place: Place { section: "5.1", label: "Theorem 5.2" },
    kind: ClaimKind::Theorem,
    statement: "Whether two zonotopes of R^3 with n generators in total intersect can be decided in O(n log^2 n) time",
    ..Claim::LISTED
};
