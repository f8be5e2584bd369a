//! Section 1, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "facets-are-parallelepipeds",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "A zonotope is a convex polytope whose facets are parallelepipeds spanned by (d-1)-tuples of generators",
    remedy: Some(
        "true when any d generators are independent; coplanar generators share one facet, a zonotope of dimension d-1",
    ),
    ..Claim::LISTED
};
