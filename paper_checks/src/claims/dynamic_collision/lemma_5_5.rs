//! Section 5.2, Lemma 5.5.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.5",
    place: Place { section: "5.2", label: "Lemma 5.5" },
    kind: ClaimKind::Lemma,
    statement: "Every zonotope A of R^3 has a zonotope B with O(1/eps^2) generators and Hausdorff distance at most eps \
        D(A), computed in O(n) time",
    ..Claim::LISTED
};
