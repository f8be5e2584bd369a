//! Section 1, fifth paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "boxes-are-zonotopes",
    place: Place { section: "1", label: "fifth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Axis-aligned and oriented bounding boxes are special zonotopes",
    ..Claim::LISTED
};
