//! Section 1, third bullet.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "variable-complexity",
    place: Place { section: "1", label: "third bullet" },
    kind: ClaimKind::Statement,
    statement: "The number of generators can vary over a bounding volume hierarchy, with more of them where few nodes \
        would otherwise fit badly",
    ..Claim::LISTED
};
