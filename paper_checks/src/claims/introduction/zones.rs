//! Section 1, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "zones-are-bands",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "In R^3 the facets that share a generator form a band around the zonotope",
    ..Claim::LISTED
};
