//! The cutting of Z(O) that Figure 2 shows.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, signed_area, zonogon_area};
use crate::definitions::runs::{Run, runs};
use crate::instances::polygons::{generator, listed, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "figure-2",
    place: Place { section: "4.1", label: "Figure 2" },
    kind: ClaimKind::Figure,
    statement: "Z(O) is cut into the quadrilaterals O P_a P'_{a'} P_{a+1} and the caps beyond them, which is the first \
        line of the area formula",
    code: &["zonotope::enclosing::centered_zonogon"],
    figures: &["paper-figure-2"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// The pieces have positive area when they do not vanish, and the areas add up to that of Z(O).
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 6);
    let mut pieces = 0;
    for instance in polygons(&mut random, 50) {
        let polygon = &instance.polygon;
        let center = random_center(&mut random, polygon);
        let Some(runs) = runs(polygon, &center) else {
            continue;
        };
        let areas = piece_areas(&runs, &center);
        let mut total = RBig::ZERO;
        for area in &areas {
            total += area;
        }
        if total != zonogon_area(polygon, &center) || areas.iter().any(|area| *area < RBig::ZERO) {
            return Verdict::Refuted(format!("{} about {center}", listed(polygon)));
        }
        pieces += areas.len();
    }
    Verdict::Holds(format!("{pieces} pieces, none of negative area, add up to their zonogons"))
}

/// The quadrilaterals and the caps on both sides of each.
fn piece_areas(runs: &[Run], center: &Point) -> Vec<RBig> {
    (0..runs.len())
        .flat_map(|s| {
            let (run, next) = (&runs[s], &runs[(s + 1) % runs.len()].original[0]);
            let corner = &run.reflected[0];
            [
                signed_area([center, &run.original[0], corner, next]),
                signed_area(run.original.iter().chain([corner])),
                signed_area(run.reflected.iter().chain([next])),
            ]
        })
        .collect()
}
