//! Section 6, after Theorem 6.1.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "any-schedule",
    place: Place { section: "6", label: "after Theorem 6.1" },
    kind: ClaimKind::Statement,
    statement: "The bound holds whatever the velocity and the angular acceleration during the motion: only the set of \
        positions matters",
    ..Claim::LISTED
};
