//! Section 5.1, separators.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-5.1-separators",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Erratum,
    statement: "L_k meets the lines from left to right, and the chain extends v' by v'",
    remedy: Some(
        "L_k meets them from top to bottom; a step is 2 v' in half-lengths, every v' turned to point up; v' = 0 has no line, a horizontal v' is never crossed, equal x need a rule",
    ),
    ..Claim::LISTED
};
