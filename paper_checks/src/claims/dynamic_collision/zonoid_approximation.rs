//! Section 5.2, hierarchical method, quoted from [2].

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "zonoid-approximation",
    place: Place { section: "5.2", label: "hierarchical method, quoted from [2]" },
    kind: ClaimKind::Statement,
    statement: "Every zonoid of R^d is within eps of its diameter of a zonotope with O(d / eps^(2 + tau)) generators, \
        for any tau > 0",
    ..Claim::LISTED
};
