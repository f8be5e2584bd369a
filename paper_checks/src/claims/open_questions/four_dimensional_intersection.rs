//! Section 7, fourth question.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "open-4d-intersection",
    place: Place { section: "7", label: "fourth question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How are 4-D space-time zonotopes intersected efficiently?",
    ..Claim::LISTED
};
