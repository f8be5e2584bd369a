//! Section 6, fourth to sixth paragraph.

use crate::claim::{Claim, ClaimKind, Correction, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-6-rotation",
    place: Place { section: "6", label: "fourth to sixth paragraph" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "The square around the circle through the farthest arc end bounds the rotation, in whatever order \
        rotation and translation happen",
    remedy: Some(
        "the radius is 2 r sin(min(theta, 180 degrees)/2), r the largest distance of a vertex from the axis; the body \
            is rotated about the axis first and translated then, on any schedule; about a moving axis it is not \
            covered",
    ),
    ..Claim::LISTED
};
