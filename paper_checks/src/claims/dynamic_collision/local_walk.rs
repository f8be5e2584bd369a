//! Section 5.2, local walking method.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "local-walk",
    place: Place { section: "5.2", label: "local walking method" },
    kind: ClaimKind::Statement,
    statement: "Tracking the closest pair of features needs only the neighbours of a feature, which can be found from \
        the generators on the fly",
    ..Claim::LISTED
};
