//! Section 4.2, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-4.2-extreme-points",
    place: Place { section: "4.2", label: "second paragraph" },
    kind: ClaimKind::Erratum,
    statement: "The two extreme points along each facet normal suffice, whatever the directions",
    remedy: Some(
        "right when the directions span R^d; otherwise work in the span, where points off the affine span make the problem infeasible. Directions e1, e2 of R^3 with the unit square in z = 0: two extreme points give 1/2, the optimum is 1",
    ),
    ..Claim::LISTED
};
