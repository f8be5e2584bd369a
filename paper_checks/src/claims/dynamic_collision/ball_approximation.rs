//! Section 5.2, hierarchical method, quoted from [1].

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "ball-approximation",
    place: Place { section: "5.2", label: "hierarchical method, quoted from [1]" },
    kind: ClaimKind::Statement,
    statement: "The unit ball of R^3 is within Hausdorff distance eps of a zonotope with O(1/eps) generators",
    ..Claim::LISTED
};
