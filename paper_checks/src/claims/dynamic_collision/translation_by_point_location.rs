//! Section 5.2, Minkowski sum method.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "translation-by-point-location",
    place: Place { section: "5.2", label: "Minkowski sum method" },
    kind: ClaimKind::Statement,
    statement: "For bodies that only translate, repeated intersection tests are point locations in one Minkowski sum",
    ..Claim::LISTED
};
