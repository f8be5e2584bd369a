//! Section 2, second bullet.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "summary-fixed-directions",
    place: Place { section: "2", label: "second bullet" },
    kind: ClaimKind::Statement,
    statement: "With generators along k given directions of R^d, the enclosing zonotope of least total length takes \
        O(n k^(d-1) + k^O(d)) time",
    check: Check::Restates("theorem-4.6"),
    ..Claim::LISTED
};
