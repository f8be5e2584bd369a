//! Section 6, sixth paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "farthest-vertex-from-axis",
    place: Place { section: "6", label: "sixth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The vertex farthest from the rotation axis is found from the zonogon of the projected generators in \
        O(n log n) time",
    ..Claim::LISTED
};
