//! Section 1, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "affine-image-of-cube",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "The Minkowski sum of n segments is the same set as an affine image of the unit cube of R^n",
    ..Claim::LISTED
};
