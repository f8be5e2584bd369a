//! Section 4.1, before Theorem 4.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "halving-search",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "Each step of the search halves the candidate vertices by slope selection, in O(n log n) time, so O(log n) steps find the minimum",
    ..Claim::LISTED
};
