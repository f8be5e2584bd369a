//! Section 7, third question.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "open-generator-count",
    place: Place { section: "7", label: "third question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How many generators does that zonotope have?",
    figures: &["few-generators"],
    ..Claim::LISTED
};
