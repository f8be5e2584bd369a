//! Section 5.2, hierarchical method, quoted from [7].

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "convex-approximation",
    place: Place { section: "5.2", label: "hierarchical method, quoted from [7]" },
    kind: ClaimKind::Statement,
    statement: "Every convex body of R^3 is within eps of its diameter, in Hausdorff distance, of a convex body with \
        O(1/eps) vertices",
    ..Claim::LISTED
};
