//! Section 5.1, after Lemma 5.1.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "between-the-hulls",
    place: Place { section: "5.1", label: "after Lemma 5.1" },
    kind: ClaimKind::Statement,
    statement: "A point lies in Z iff it is directly below the upper hull and directly above the lower hull; if its projection is outside Q it is not",
    ..Claim::LISTED
};
