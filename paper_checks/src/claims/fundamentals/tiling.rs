//! Section 3, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "upper-hull-tiling",
    place: Place { section: "3", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "In R^3 the upper hull projects to a tiling of a convex polygon Q by translates of the parallelograms of the projected generators, one for each pair",
    ..Claim::LISTED
};
