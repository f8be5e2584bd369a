//! Section 7, fifth question.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "question-hierarchies",
    place: Place { section: "7", label: "fifth question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How can bounding volume hierarchies of zonotopes be built for arbitrary polyhedral geometry?",
    ..Claim::LISTED
};
