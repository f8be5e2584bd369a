//! Section 1, second bullet.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "implicit-representation",
    place: Place { section: "1", label: "second bullet" },
    kind: ClaimKind::Statement,
    statement: "n generators represent a body of up to order n^2 faces in R^3, and sums and differences are concatenations of generator lists",
    ..Claim::LISTED
};
