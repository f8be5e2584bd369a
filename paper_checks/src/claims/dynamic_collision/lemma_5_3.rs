//! Section 5.2, Lemma 5.3.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.3",
    place: Place { section: "5.2", label: "Lemma 5.3" },
    kind: ClaimKind::Lemma,
    statement: "For n <= m <= n^2, a structure of O(m) space answers membership in a zonotope of n generators in \
        O((n^2/m) log^2 n) time",
    ..Claim::LISTED
};
