//! Section 4.2, displayed program.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "linear-program",
    place: Place { section: "4.2", label: "displayed program" },
    kind: ClaimKind::Statement,
    statement: "The coefficients are the optimum of a linear program with O(k^d) equations and constraints: p_j = p + sum of b_ij v_i, |b_ij| <= c_i, minimise the sum of c_i",
    ..Claim::LISTED
};
