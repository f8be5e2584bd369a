//! Section 1, third paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "sphere-arrangement-duality",
    place: Place { section: "1", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "Outer normals map the faces of a zonotope to the arrangement of one great hypersphere per generator: facets to vertices, a zone to the vertices of its hypersphere",
    ..Claim::LISTED
};
