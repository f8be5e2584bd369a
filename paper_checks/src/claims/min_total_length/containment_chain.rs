//! Section 4.3, third paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "containment-chain",
    place: Place { section: "4.3", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "Moving every generator to the nearest net direction and adding eps D along each of the d axes gives a zonotope Z' that contains Z and has total length (1 + d eps) D",
    ..Claim::LISTED
};
