//! Section 4.3, first paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-4.3-objective",
    place: Place { section: "4.3", label: "first paragraph" },
    kind: ClaimKind::Erratum,
    statement: "What total length measures is left unsaid",
    remedy: Some(
        "it is half the first intrinsic volume, so it grows under inclusion; the vertices of a zonotope have that zonotope as optimum; in the plane the optimum is the least perimeter(Z(O)) / 4",
    ),
    ..Claim::LISTED
};
