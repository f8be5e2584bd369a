//! Section 5.1, separators.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "separator-order",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Statement,
    statement: "Numbering the tiles by the x order of the dual vertices is consistent with the right-to relation of the tiling",
    ..Claim::LISTED
};
