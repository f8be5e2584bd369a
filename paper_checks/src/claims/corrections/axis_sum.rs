//! Section 4.3, third paragraph: the sum over the axes.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::enclosing::{Row, dot};
use crate::definitions::ratio::{fraction, integer};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "sum-over-the-axes",
    place: Place { section: "4.3", label: "third paragraph, displayed chain" },
    kind: ClaimKind::Correction(Correction::Erratum),
    statement: "The zonotope with the moved generators and, for i = 1 to d, the generators eps D e_d contains Z",
    remedy: Some("read e_i: the sum runs over the axes, and the printed one takes the last axis d times"),
    code: &["zonotope::enclosing::min_total_length"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// A segment of the plane that is moved off the first axis: the last axis alone does not make up for it, both do.
fn check(_: &CheckContext) -> Verdict {
    let zero = || integer(0);
    let row = |x: RBig, y: RBig| -> Row { vec![x, y] };
    let (moved, epsilon) = (row(fraction(4, 5), fraction(3, 5)), fraction(2, 3));
    let segment = row(integer(1), zero());
    let apart: Row = segment.iter().zip(&moved).map(|(a, b)| a - b).collect();
    let is_near = dot(&apart, &apart) <= &epsilon * &epsilon;
    let axes = [row(epsilon.clone(), zero()), row(zero(), epsilon)];
    let reach = |generators: &[Row], normal: &Row| {
        generators.iter().map(|g| dot(g, normal)).fold(zero(), |sum, x| if x < zero() { sum - x } else { sum + x })
    };
    let printed = [moved.clone(), axes[1].clone(), axes[1].clone()];
    let meant = [moved.clone(), axes[0].clone(), axes[1].clone()];
    let first_axis = row(integer(1), zero());
    let is_outside = reach(&printed, &first_axis) < reach(std::slice::from_ref(&segment), &first_axis);
    // The facets of the zonotope that is meant are parallel to its generators.
    let is_inside = meant.iter().all(|side| {
        let normal = row(-side[1].clone(), side[0].clone());
        reach(std::slice::from_ref(&segment), &normal) <= reach(&meant, &normal)
    });
    if is_near && is_outside && is_inside {
        Verdict::Refuted(
            "the segment of (1, 0), moved to (4/5, 3/5), which is nearer than 2/3: with 2/3 along the second axis \
             twice, the zonotope reaches 4/5 along the first one, and the segment 1; with 2/3 along each axis it \
             contains the segment"
                .to_owned(),
        )
    } else {
        Verdict::Inconclusive("the witness is none".to_owned())
    }
}
