//! Section 4.3, third paragraph.

use crate::claim::{Claim, ClaimKind, Place};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erratum-4.3-containment",
    place: Place { section: "4.3", label: "third paragraph" },
    kind: ClaimKind::Erratum,
    statement: "The error of the net is (1 + d eps), so O(1 / eps^(d-1)) directions and the axes are needed",
    remedy: Some(
        "the optimum over R is at most the optimum over the inradius of conv(R, -R): the error is O(eps^2) in the mesh, eps^(-(d-1)/2) directions suffice, and the axes are not needed",
    ),
    ..Claim::LISTED
};
