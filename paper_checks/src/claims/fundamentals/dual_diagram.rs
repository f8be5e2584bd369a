//! Section 3, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "tiling-arrangement-duality",
    place: Place { section: "3", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "The dual diagram of the tiling is isomorphic to the arrangement of the lines P_i with z = 1: tiles to vertices, tiling edges to edges, tiling vertices to faces",
    ..Claim::LISTED
};
