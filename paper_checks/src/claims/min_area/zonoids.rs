//! Section 4.1, after Theorem 4.5.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::absolute;
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::bodies;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "most-symmetric-bodies-not-zonoids",
    place: Place { section: "4.1", label: "after Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "In R^d with d >= 3 most centrally symmetric bodies cannot be approximated arbitrarily closely by \
        zonotopes",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// A distance from the octahedron within which nothing is a zonotope.
fn distance() -> RBig {
    fraction(3, 20)
}

/// Every zonotope about the origin has Σ h(±1, ±1, ±1) / 8 ≥ Σ h(e_i) / 2; the octahedron has 1 against 3/2.
///
/// A body within δ of the octahedron has h(±1, ±1, ±1) ≤ 1 + √3 δ and h(e_i) ≥ 1 − δ: the inequality fails as long as
/// √3 δ + 3δ/2 < 1/2.
fn check(context: &CheckContext) -> Verdict {
    let signs: Vec<Vector> = (0..8)
        .map(|choice: usize| Vector::at(std::array::from_fn(|i| if choice >> i & 1 == 0 { 1 } else { -1 })))
        .collect();
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector::at);
    let sides = |reach: &dyn Fn(&Vector) -> RBig| {
        let total = |directions: &[Vector]| directions.iter().fold(RBig::ZERO, |sum, u| sum + reach(u));
        [total(&signs) / integer(8), total(&axes) / integer(2)]
    };
    let mut random = generator(context.seed, 168);
    let instances = bodies(&mut random, 200);
    for instance in &instances {
        let body = Body { center: Vector::at([0; 3]), generators: instance.body().generators };
        let [mean, half] = sides(&|u| body.reach(u));
        if mean < half {
            return Verdict::Inconclusive(format!("{}: the inequality fails", instance.name));
        }
    }
    // the octahedron conv(±e_i) reaches as far along u as the largest of its absolute coordinates
    let [mean, half] = sides(&|u| u.0.iter().map(|c| absolute(c.clone())).max().unwrap_or(RBig::ZERO));
    // √3 < 7/4
    let left = &mean + fraction(7, 4) * distance();
    let right = &half - fraction(3, 2) * distance();
    if left >= right {
        return Verdict::Inconclusive(format!("{left} is not below {right}"));
    }
    Verdict::InPart(format!(
        "the octahedron conv(±e_i), and so every body within {} of it, is no limit of zonotopes: it has sum of \
         h(±1,±1,±1) / 8 = {mean} and sum of h(e_i) / 2 = {half}, and {} zonotopes have no less on the left than on \
         the right, as each segment has; that most bodies are like it is not checked",
        distance(),
        instances.len()
    ))
}
