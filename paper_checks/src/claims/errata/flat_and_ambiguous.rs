//! Section 4.1, before Theorem 4.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-4.1-vertex",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Erratum,
    statement: "The minimum is at a vertex of the arrangement, and there is one to be located",
    remedy: Some(
        "one point, two points and collinear points have no arrangement: their zonogon is the segment, of area 0; and the minimiser need not be unique",
    ),
    ..Claim::LISTED
};
