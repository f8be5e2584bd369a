//! Section 2, sixth bullet.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "summary-space-time",
    place: Place { section: "2", label: "sixth bullet" },
    kind: ClaimKind::Statement,
    statement: "Bounding space-time volumes of moving zonotopes are easy to build, so that no collision is missed",
    figures: &["motion-time-bar"],
    check: Check::Restates("theorem-6.1"),
    ..Claim::LISTED
};
