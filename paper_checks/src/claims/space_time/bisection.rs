//! Section 6, second paragraph.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "interval-bisection",
    place: Place { section: "6", label: "second paragraph" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "Halving the time step again and again ends in a confirmed collision or a confirmed miss",
    remedy: Some(
        "it ends when the bodies are apart during the whole step or overlap for a while; where they touch at one \
            moment alone a program has to stop at a width, with an outcome of its own: free before, and within a \
            stated distance then",
    ),
    code: &["zonotope::motion::continuous::by_space_time_volumes", "zonotope::motion::continuous"],
    figures: &["swept-volumes", "motion-time-bar", "control-zonotopes"],
    check: Check::Run(check),
    tried: Tried::Witness,
};

/// The number of times that the step is halved.
const HALVINGS: usize = 60;

/// A point that moves from (0, 2, 0) by (3, −3, 0) touches the cube of half-lengths 1 at a third of the step, which no
/// halving hits: the bodies are apart at both ends of each part around it, and the volume of each, a segment, is its
/// exact sweep and touches the cube.
fn check(_: &CheckContext) -> Verdict {
    let cube = Body::about_origin(&[[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    let at = |time: &RBig| Vector::at([0, 2, 0]).plus(time, &Vector::at([3, -3, 0]));
    let third = fraction(1, 3);
    if !cube.holds(&at(&third)) {
        return Verdict::Inconclusive("the point does not touch the cube".to_owned());
    }
    let [mut from, mut until] = [integer(0), integer(1)];
    for _ in 0..HALVINGS {
        let middle = (&from + &until) / integer(2);
        if third < middle {
            until = middle
        } else {
            from = middle
        }
        let is_open = from < third && third < until && !cube.holds(&at(&from)) && !cube.holds(&at(&until));
        if !is_open {
            return Verdict::Inconclusive(format!("the part from {from} to {until} is decided"));
        }
    }
    Verdict::Refuted(format!(
        "a point that moves from (0, 2, 0) by (3, -3, 0) touches the cube of half-lengths 1 at a third of the step \
         alone: after {HALVINGS} halvings it is outside at both ends of the part around that time, and its volume \
         there, the exact sweep, touches the cube"
    ))
}
