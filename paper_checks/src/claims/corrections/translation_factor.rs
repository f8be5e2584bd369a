//! Section 6, third paragraph.

use crate::claim::{Claim, ClaimKind, Correction, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "half-of-translation",
    place: Place { section: "6", label: "third paragraph" },
    kind: ClaimKind::Correction(Correction::Erratum),
    statement: "The translation vector v is added to the list of generators, and the result is anchored at the origin \
        of P translated by v/2",
    remedy: Some(
        "in half-lengths the added generator is v/2: the unit cube moved by (10,0,0) sweeps 48 with half-lengths of 1, \
            and the printed version gives 88",
    ),
    ..Claim::LISTED
};
