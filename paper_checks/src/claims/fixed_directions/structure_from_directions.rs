//! Section 4.2, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "structure-from-directions",
    place: Place { section: "4.2", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "The combinatorial structure of a zonotope depends on the directions of its generators and not on their lengths",
    ..Claim::LISTED
};
