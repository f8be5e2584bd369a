//! Section 5.2, Lemma 5.6.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.6",
    place: Place { section: "5.2", label: "Lemma 5.6" },
    kind: ClaimKind::Lemma,
    statement: "After O(n log n) preprocessing with O(n) space, a face-to-face walk on a zonotope of n generators \
        takes O(log^2 n) time a step",
    ..Claim::LISTED
};
