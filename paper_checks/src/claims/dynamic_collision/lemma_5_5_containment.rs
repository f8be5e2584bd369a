//! Section 5.2, proof of Lemma 5.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.5-containment",
    place: Place { section: "5.2", label: "proof of Lemma 5.5" },
    kind: ClaimKind::Statement,
    statement: "The approximation B of the proof contains A",
    ..Claim::LISTED
};
