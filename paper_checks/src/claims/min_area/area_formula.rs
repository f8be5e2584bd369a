//! The area formula: first, second and last displayed lines.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::zonogon_area;
use crate::definitions::runs::{displayed_lines, runs};
use crate::instances::polygons::{generator, listed, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "area-formula",
    place: Place { section: "4.1", label: "displayed formula" },
    kind: ClaimKind::Statement,
    statement: "In the notation of the combinatorial description, f(O) = sum over s of ([P_{a'} P_a P_{a+1}] + 4 [P_a \
        ... P_b O] - 2 [P_a ... P_b P_{a'}]) - [P_{a_1} ... P_{a_k}], the last displayed line",
    code: &["zonotope::enclosing::min_area_zonogon"],
    figures: &["paper-figure-2"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Compares the displayed lines other than the third with the area of the hull.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 5);
    let mut by_runs: [usize; 3] = [0; 3];
    for instance in polygons(&mut random, 90) {
        let polygon = &instance.polygon;
        for _ in 0..6 {
            let center = random_center(&mut random, polygon);
            let Some(runs) = runs(polygon, &center) else {
                continue;
            };
            let area = zonogon_area(polygon, &center);
            let lines = displayed_lines(&runs, &center);
            for (number, line) in [("first", &lines[0]), ("second", &lines[1]), ("last", &lines[3])] {
                let gap: RBig = line - &area;
                if gap != RBig::ZERO {
                    return Verdict::Refuted(format!(
                        "the {number} line is off by {gap} for {} about {center}",
                        listed(polygon)
                    ));
                }
            }
            by_runs[(runs.len() / 2).min(2)] += 1;
        }
    }
    let [one, three, more] = by_runs;
    Verdict::Holds(format!(
        "the first, second and last lines equal the area of Z(O) exactly: {one} times with k = 1, {three} with k = 3, \
            {more} with k >= 5"
    ))
}
