//! Section 6, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "interval-bisection",
    place: Place { section: "6", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Halving the time step again and again ends in a confirmed collision or a confirmed miss",
    ..Claim::LISTED
};
