//! Unimodal on every line is too weak.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::{generator, random_point};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "unimodal-on-lines",
    place: Place { section: "4.1", label: "Lemma 4.3 to Corollary 4.4" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "A planar function which is unimodal over all lines in its domain is itself unimodal, and the unimodal \
        property tells on which side of a line the global minimum is",
    remedy: Some(
        "true when unimodal means that the function falls strictly to its minimum and rises strictly from it, which is \
            not said, and f has flat pieces; what serves is that f is convex, being a sum of hinges: then a point \
            that is least on its line and has a zero subgradient is a global minimum",
    ),
    code: &["zonotope::lad"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// g(x, y) = r for r = max(|x|, |y|) up to 1, then 1 up to 2, then r - 1: every sublevel set is a square.
fn g(point: &Point) -> RBig {
    let size = |value: &RBig| if *value < RBig::ZERO { -value.clone() } else { value.clone() };
    let r = size(&point.x).max(size(&point.y));
    if r <= integer(2) { r.min(RBig::ONE) } else { r - RBig::ONE }
}

/// Shows that g is unimodal on lines, yet flat around a point that is no minimum, and not convex.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 16);
    let mut lines = 0;
    for _ in 0..200 {
        let (from, to) = (random_point(&mut random, 4), random_point(&mut random, 4));
        let values: Vec<RBig> = (-20..=40).map(|step| g(&from.plus(&fraction(step, 20), &from.to(&to)))).collect();
        let lowest = values.iter().min().expect("the samples are not empty");
        let bottom = values.iter().position(|value| value == lowest).expect("the least value is one of them");
        let (falling, rising) = values.split_at(bottom);
        if falling.windows(2).any(|pair| pair[0] < pair[1]) || rising.windows(2).any(|pair| pair[0] > pair[1]) {
            return Verdict::Inconclusive(format!("g rises and falls again between {from} and {to}"));
        }
        lines += 1;
    }
    let stuck = Point::new(fraction(3, 2), RBig::ZERO);
    let around: Vec<Point> = (-1..=1)
        .flat_map(|x| (-1..=1).map(move |y| (x, y)))
        .map(|(x, y)| stuck.plus(&fraction(1, 4), &Point::at(x, y)))
        .collect();
    let flat = around.iter().all(|point| g(point) == g(&stuck));
    let lower = g(&Point::at(0, 0)) < g(&stuck);
    let bulges = integer(2) * g(&Point::at(1, 0)) > g(&Point::at(0, 0)) + g(&Point::at(2, 0));
    if !(flat && lower && bulges) {
        return Verdict::Holds("the counterexample is none".to_owned());
    }
    Verdict::Refuted(format!(
        "g = r for r = max(abs x, abs y) <= 1, 1 for 1 <= r <= 2, r - 1 beyond: on {lines} lines it falls, then rises, \
         but around (3/2, 0) it is constant, 1, while g(0, 0) = 0; the vertical line through that point tells no side"
    ))
}
