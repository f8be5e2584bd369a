//! Section 5.2, proof of Lemma 5.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-5.2-lemma-5.5",
    place: Place { section: "5.2", label: "proof of Lemma 5.5" },
    kind: ClaimKind::Erratum,
    statement: "Any subdivision of the hemisphere into k patches of angle O(1/sqrt(k)) will do",
    remedy: Some(
        "patches must stay below 90 degrees so that every v_i . n_j >= 0: v = (10,0,1) and (-10,0,1) with n = (1,0,0) \
            lose (20,0,0)",
    ),
    ..Claim::LISTED
};
