//! The size of the explicit boundary.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "explicit-size",
    place: Place { section: "5", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "The explicit boundary of a zonotope of R^3 with n generators has of order n^2 faces, so explicit \
        methods are inefficient",
    check: Check::Restates("face-count"),
    ..Claim::LISTED
};
