//! Section 5.2, the diameter in the proof of Lemma 5.5.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::Vector;
use crate::instances::bodies::{bodies, bodies_in_general_position};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "diameter-and-total-length",
    place: Place { section: "5.2", label: "proof of Lemma 5.5" },
    kind: ClaimKind::Statement,
    statement: "The diameter of a zonotope A is at least a constant times the total length of its generators",
    remedy: Some("the constant 2/3 is enough: along one of three axes the generators reach a third of their length"),
    code: &["zonotope::reduction"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies", "bodies in general position"]),
    ..Claim::LISTED
};

/// Twice the reach along an axis is no more than the diameter, and the reaches along three add up to at least the
/// lengths.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 110);
    let mut instances = bodies(&mut random, 40);
    instances.extend(bodies_in_general_position(&mut random, 21));
    for instance in &instances {
        let body = instance.body();
        let reaches = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis| body.reach(&Vector::at(axis)));
        let widest = reaches.iter().max().cloned().unwrap_or(RBig::ZERO);
        // A length is at most the sum of the absolute coordinates, which needs no square root.
        let lengths = reaches.iter().fold(RBig::ZERO, |sum, reach| sum + reach);
        if integer(2) * widest < fraction(2, 3) * lengths {
            return Verdict::Refuted(instance.name.clone());
        }
    }
    Verdict::Holds(format!(
        "of {} bodies, flat and empty ones among them, twice the largest reach along an axis is at least 2/3 of a \
         bound from above of the total length",
        instances.len()
    ))
}
