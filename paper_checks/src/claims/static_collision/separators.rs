//! Section 5.1, separators.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "separators",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Statement,
    statement: "The chain of the projected generators in the order in which the vertical line L_k meets their lines separates the first k tiles from the others, and is built in O(n log n) time",
    ..Claim::LISTED
};
