//! Section 5.2, Lemma 5.6.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-5.2-lemma-5.6",
    place: Place { section: "5.2", label: "Lemma 5.6" },
    kind: ClaimKind::Erratum,
    statement: "Each face has four neighbours, found as neighbours of a vertex of the arrangement",
    remedy: Some(
        "an unbounded edge of the arrangement leads from the upper hull to the antipodal facet, and a facet of \
            coplanar generators has more than four neighbours",
    ),
    ..Claim::LISTED
};
