//! Section 4.1, after Theorem 4.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "volume-formula",
    place: Place { section: "4.1", label: "after Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "The volume of a zonotope is the sum of the volumes of the parallelepipeds formed by all d-tuples of generators",
    ..Claim::LISTED
};
