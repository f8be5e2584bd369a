//! Section 7, second question.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "question-optimal-volume",
    place: Place { section: "7", label: "second question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How fast can the zonotope of least volume be computed?",
    ..Claim::LISTED
};
