//! Section 4.2, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "extreme-points-suffice",
    place: Place { section: "4.2", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Only the two extreme points along each facet normal, n' = O(k^(d-1)) in all, matter to the discrete oriented enclosing zonotope",
    ..Claim::LISTED
};
