//! Section 2, fifth bullet.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "summary-repeated-tests",
    place: Place { section: "2", label: "fifth bullet" },
    kind: ClaimKind::Statement,
    statement: "Bounding volume hierarchies and closest-feature tracking can be run for repeated tests on the \
        generator lists alone",
    ..Claim::LISTED
};
