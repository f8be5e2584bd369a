//! Section 5.2, proof of Lemma 5.3.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-5.2-lemma-5.3",
    place: Place { section: "5.2", label: "proof of Lemma 5.3" },
    kind: ClaimKind::Erratum,
    statement: "A cell of the mapped cutting is crossed by the lines that cross its trapezoid",
    remedy: Some(
        "a tile of a sampled line can straddle cells: keep the boundary lines of a trapezoid among its crossing lines",
    ),
    ..Claim::LISTED
};
