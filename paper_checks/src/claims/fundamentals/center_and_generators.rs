//! Section 3, definition.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "center-and-generators",
    place: Place { section: "3", label: "definition" },
    kind: ClaimKind::Statement,
    statement: "A Minkowski sum of finitely many segments is { p + sum of delta_i v_i : |delta_i| <= 1 } for a centre p and generators v_i, and conversely",
    ..Claim::LISTED
};
