//! Section 1, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "central-symmetry",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Every zonotope is centrally symmetric, and every facet has an opposite congruent one",
    ..Claim::LISTED
};
