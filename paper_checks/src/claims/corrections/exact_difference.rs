//! The difference of two centres.

use zonotope::collision::{Query, by_lad};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "difference-of-centers",
    place: Place { section: "5.1", label: "Lemma 5.1" },
    kind: ClaimKind::Note,
    statement: "Whether q - p is in the zonotope of all generators decides whether the two zonotopes intersect",
    remedy: Some("q - p must be exact: centres 1e16 and -1 turn from disjoint to touching by rounding"),
    code: &["zonotope::collision"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Two segments on the x axis whose centres are 1e16 + 1 apart and whose half-lengths sum to 1e16.
fn check(_context: &CheckContext) -> Verdict {
    let (p, q, half) = (-1.0, 1e16, 1e16);
    let segment = |center: f64, half: f64| {
        Zonotope::new([center, 0.0, 0.0], vec![[half, 0.0, 0.0]]).expect("the coordinates are finite")
    };
    let answer = by_lad::locate(&Query::between(&segment(p, half), &segment(q, 0.0)), &mut ());
    let sum = Body { center: Vector::exactly([p, 0.0, 0.0]), generators: vec![Vector::exactly([half, 0.0, 0.0])] };
    let truth = sum.holds(&Vector::exactly([q, 0.0, 0.0]));
    let rounded = q - p <= half;
    if truth || answer.is_member() || !rounded {
        return Verdict::Refuted(format!("exactly {truth}, rounded {rounded}, the library: {}", answer.status()));
    }
    Verdict::Holds(
        "the segment of half-length 1e16 about -1 ends at 1e16 - 1 and misses the point 1e16, but the rounded \
         difference of the centres is 1e16, on the boundary; with the exact difference the library finds them disjoint"
            .to_owned(),
    )
}
