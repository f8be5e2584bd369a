//! Section 3, first paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-3-independent-generators",
    place: Place { section: "3", label: "first paragraph" },
    kind: ClaimKind::Erratum,
    statement: "Any d generators may be assumed linearly independent",
    remedy: Some(
        "merge parallel generators, drop zero ones, gather coplanar ones into one facet, and accept flat and empty zonotopes: the difference of two boxes has parallel generators, the truncated octahedron has coplanar triples, and 4.2 gives zero coefficients",
    ),
    ..Claim::LISTED
};
