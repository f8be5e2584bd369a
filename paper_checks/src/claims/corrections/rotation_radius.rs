//! Section 6, fourth to sixth paragraph.

use crate::claim::{Claim, ClaimKind, Correction, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "radius-of-rotation",
    place: Place { section: "6", label: "fourth to sixth paragraph" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "The generators of P with v and the two of the square around the circle through the farthest arc end \
        bound P throughout the rigid motion",
    remedy: Some(
        "true when the body is rotated about the axis first and translated then, on any schedule; the radius is 2 r \
            sin(min(theta, 180 degrees)/2), r the largest distance of a vertex from the axis; about a moving axis it \
            is not covered",
    ),
    ..Claim::LISTED
};
