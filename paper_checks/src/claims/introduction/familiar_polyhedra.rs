//! Section 1, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "familiar-zonotopes",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Cubes, parallelepipeds, the truncated octahedron and the rhombic dodecahedron are zonotopes",
    ..Claim::LISTED
};
