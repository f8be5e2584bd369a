//! Section 6, fifth paragraph.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "number-of-arcs",
    place: Place { section: "6", label: "fifth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The number of arcs, one for each vertex, can be of order n^2 for n generators of P",
    check: Check::Restates("face-count"),
    ..Claim::LISTED
};
