//! Section 3, Figure 1.

use crate::claim::{Check, Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "figure-1",
    place: Place { section: "3", label: "Figure 1" },
    kind: ClaimKind::Figure,
    statement: "The arrangement of the lines, the tiling dual to it, a vertical line and its pseudo-vertical \
        counterpart",
    figures: &["paper-figure-1"],
    check: Check::Restates("separators"),
    ..Claim::LISTED
};
