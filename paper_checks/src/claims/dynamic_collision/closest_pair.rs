//! Section 5.2, local walking method, quoted from [14].

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "closest-pair-by-walking",
    place: Place { section: "5.2", label: "local walking method, quoted from [14]" },
    kind: ClaimKind::Statement,
    statement: "A simple local walking strategy is guaranteed to find the closest pair of features of two convex \
        volumes",
    ..Claim::LISTED
};
