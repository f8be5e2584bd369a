//! Section 6, third paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "pure-translation",
    place: Place { section: "6", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "Adding the translation vector to the generators, with the centre moved by half of it, gives exactly \
        the volume swept by a translating zonotope",
    ..Claim::LISTED
};
