//! The minimum is at a vertex of the arrangement.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{bisectors, least_area, zonogon_area};
use crate::definitions::subdifferential::is_minimizer;
use crate::instances::polygons::{generator, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "minimum-at-vertex",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "f has a global minimum at a vertex of the arrangement",
    code: &["zonotope::lad::of_lines::brute_force"],
    figures: &["arrangement-and-level-sets"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Takes the best vertex by trying all, then shows that no direction from it descends and no sampled point is lower.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 14);
    let (mut tried, mut ambiguous) = (0, 0);
    for instance in polygons(&mut random, 60) {
        let polygon = &instance.polygon;
        let lines = bisectors(polygon);
        let (least, minimizers) = least_area(polygon);
        if !minimizers.iter().all(|vertex| is_minimizer(&lines, vertex)) {
            return Verdict::Refuted(format!("{}: f descends from its best vertex", instance.name));
        }
        for _ in 0..10 {
            let center = random_center(&mut random, polygon);
            if zonogon_area(polygon, &center) < least {
                return Verdict::Refuted(format!("{}: f({center}) is below every vertex", instance.name));
            }
        }
        tried += 1;
        ambiguous += usize::from(minimizers.len() > 1);
    }
    Verdict::Holds(format!(
        "for {tried} polygons with area no direction descends from the best vertex; for {ambiguous} of them several \
            vertices are best"
    ))
}
