//! Section 5.2, proof of Corollary 5.4.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-5.2-corollary-5.4",
    place: Place { section: "5.2", label: "proof of Corollary 5.4" },
    kind: ClaimKind::Erratum,
    statement: "Locating a ray from the origin is the same as locating a point",
    remedy: Some(
        "one step is missing: the silhouette is star-shaped from the centre, so the side test works for rays; off the \
            span of a flat zonotope the distance is infinite",
    ),
    ..Claim::LISTED
};
