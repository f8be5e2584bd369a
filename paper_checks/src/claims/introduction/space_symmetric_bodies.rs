//! Section 1, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "spatial-symmetric-not-zonotope",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "In three and more dimensions there are centrally symmetric convex polytopes that are not zonotopes",
    ..Claim::LISTED
};
