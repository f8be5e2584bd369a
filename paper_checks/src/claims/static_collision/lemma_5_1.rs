//! Section 5.1, Lemma 5.1.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.1",
    place: Place { section: "5.1", label: "Lemma 5.1" },
    kind: ClaimKind::Lemma,
    statement: "Two zonotopes intersect iff the difference of their centres lies in the centred zonotope of all their generators",
    ..Claim::LISTED
};
