//! Section 4.1, after Theorem 4.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "most-symmetric-bodies-not-zonoids",
    place: Place { section: "4.1", label: "after Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "In R^d with d >= 3 most centrally symmetric bodies cannot be approximated arbitrarily closely by \
        zonotopes",
    ..Claim::LISTED
};
