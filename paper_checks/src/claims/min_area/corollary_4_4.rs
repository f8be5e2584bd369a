//! Corollary 4.4, and more: f is convex.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, arrangement_vertices, bisectors, zonogon_area};
use crate::definitions::ratio::integer;
use crate::instances::polygons::{generator, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "corollary-4.4",
    place: Place { section: "4.1", label: "Corollary 4.4" },
    kind: ClaimKind::Corollary,
    statement: "f is unimodal",
    code: &["zonotope::lad"],
    figures: &["arrangement-and-level-sets"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Compares f at midpoints with the mean of f at the ends: convexity, from which unimodality follows.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 12);
    let (mut tried, mut strict) = (0, 0);
    for instance in polygons(&mut random, 50) {
        let polygon = &instance.polygon;
        let vertices = arrangement_vertices(&bisectors(polygon));
        for trial in 0..12 {
            let mut end = |index: usize| -> Point {
                if trial % 2 == 0 {
                    random_center(&mut random, polygon)
                } else {
                    vertices[(trial * 7 + index * 3) % vertices.len()].clone()
                }
            };
            let (one, other) = (end(0), end(1));
            let f = |center: &Point| zonogon_area(polygon, center);
            let (double_middle, sum) = (integer(2) * f(&one.midpoint(&other)), f(&one) + f(&other));
            if double_middle > sum {
                return Verdict::Refuted(format!("{} between {one} and {other}", instance.name));
            }
            tried += 1;
            strict += usize::from(double_middle < sum);
        }
    }
    Verdict::Holds(format!(
        "stronger: f is convex; at {tried} midpoints it is at most the mean of the ends ({strict} times below it)"
    ))
}
