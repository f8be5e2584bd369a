//! Section 7, first question.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "open-approximation-quality",
    place: Place { section: "7", label: "first question" },
    kind: ClaimKind::OpenQuestion,
    statement: "In R^3, how well can a zonotope approximate a given centrally symmetric convex polyhedron?",
    ..Claim::LISTED
};
