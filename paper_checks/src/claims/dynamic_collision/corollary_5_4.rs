//! Section 5.2, Corollary 5.4.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "corollary-5.4",
    place: Place { section: "5.2", label: "Corollary 5.4" },
    kind: ClaimKind::Corollary,
    statement: "For n <= m <= n^2, a structure of O(m) space built in O(m log n) time gives the distance of two points \
        in the metric of a zonotope in O((n^2/m) log^2 n) time",
    ..Claim::LISTED
};
