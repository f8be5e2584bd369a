//! Section 4.3, second paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "direction-net",
    place: Place { section: "4.3", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "O(1 / eps^(d-1)) unit vectors suffice to have one within eps of every unit vector",
    ..Claim::LISTED
};
