//! Section 5.1: bodies about the origin.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "centered-body",
    place: Place { section: "5.1", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "When the center coincides with the origin, a zonotope coincides with its reflection through the origin",
    check: Check::Restates("central-symmetry"),
    ..Claim::LISTED
};
