//! Section 5.1, Lemma 5.1.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-5.1-difference",
    place: Place { section: "5.1", label: "Lemma 5.1" },
    kind: ClaimKind::Erratum,
    statement: "q - p may be formed like any other number",
    remedy: Some("it must be exact: centres 1e16 and -1 turn from disjoint to touching by rounding"),
    ..Claim::LISTED
};
