//! Section 5.2, Minkowski sum method.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "arrangement-trade-off",
    place: Place { section: "5.2", label: "Minkowski sum method" },
    kind: ClaimKind::Statement,
    statement: "The best known trade-off for point location among n lines is roughly O(n / sqrt(m)) query time by \
        using O(m) preprocessing time and space; the same bound is not achieved for zonotopes",
    remedy: Some("for zonotopes Lemma 5.3 has the weaker trade-off O((n^2/m) log^2 n)"),
    ..Claim::LISTED
};
