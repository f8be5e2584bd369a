//! Section 4.1, sixth paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "evaluation-in-linear-time",
    place: Place { section: "4.1", label: "sixth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Given the polygon H and O, Z(O) and f(O) are computed in O(n) time",
    ..Claim::LISTED
};
