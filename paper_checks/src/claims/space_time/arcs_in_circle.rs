//! Section 6, fifth paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "arcs-in-circle",
    place: Place { section: "6", label: "fifth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The arcs of the vertices, each below 180 degrees and moved to a common origin, lie in the circle whose \
        radius is the distance of the farthest end point, and so in a square of two generators",
    ..Claim::LISTED
};
