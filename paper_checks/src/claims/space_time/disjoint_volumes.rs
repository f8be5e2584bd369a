//! Section 6, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "disjoint-space-time-volumes",
    place: Place { section: "6", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "If the bounding space-time volumes of two bodies are disjoint over a time step, the bodies do not \
        collide in it; the converse fails",
    ..Claim::LISTED
};
