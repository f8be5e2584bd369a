//! Section 4.2, the time of the linear program.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "program-in-polynomial-time",
    place: Place { section: "4.2", label: "after the program, quoted from [18]" },
    kind: ClaimKind::Statement,
    statement: "The linear program is solved in polynomial time by interior methods, and so in O(k^O(d)) time",
    ..Claim::LISTED
};
