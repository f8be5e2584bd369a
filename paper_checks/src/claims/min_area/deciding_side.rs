//! On which side of a vertical line the minimum lies.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, bisectors, hinge_sum, least_area, zonogon_area};
use crate::definitions::subdifferential::{deciding_interval, least_on_vertical};
use crate::instances::polygons::{generator, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "deciding-side",
    place: Place { section: "4.1", label: "after Corollary 4.4" },
    kind: ClaimKind::Statement,
    statement: "From the least point O_l of f on a vertical line, found in O(n log n) time, one can tell whether it is \
        the global minimum and, if not, on which side the minimum lies",
    code: &["zonotope::lad::of_lines::by_slope_selection"],
    figures: &["search-of-theorem-4-5"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Decides by the subgradients at O_l that vanish along the line, and compares with all minimisers.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 13);
    let mut sides = [0; 3];
    for instance in polygons(&mut random, 50) {
        let polygon = &instance.polygon;
        let lines = bisectors(polygon);
        let (least, minimizers) = least_area(polygon);
        let mut places: Vec<RBig> = (0..5).map(|_| random_center(&mut random, polygon).x).collect();
        places.extend(lines.iter().map(|line| line.start.x.clone()));
        places.extend(minimizers.iter().map(|point| point.x.clone()));
        for x in places {
            let center = least_on_vertical(&lines, &x);
            let Some((low, high)) = deciding_interval(&lines, &center) else {
                return Verdict::Refuted(format!("{}: no flat subgradient at {center}", instance.name));
            };
            let agrees = |side: fn(&RBig, &RBig) -> bool| minimizers.iter().all(|point: &Point| side(&point.x, &x));
            let (index, right) = if low > RBig::ZERO {
                (0, agrees(|point, line| point < line))
            } else if high < RBig::ZERO {
                (2, agrees(|point, line| point > line))
            } else {
                (1, zonogon_area(polygon, &center) == least)
            };
            if !right || hinge_sum(&lines, &center) > hinge_sum(&lines, &Point::new(x.clone(), RBig::ZERO)) {
                return Verdict::Refuted(format!("{} at x = {x}", instance.name));
            }
            sides[index] += 1;
        }
    }
    let [left, here, right] = sides;
    Verdict::Holds(format!(
        "the subgradients at O_l that vanish along the line tell the side: left {left} times, right {right} times, and \
         {here} times that O_l is a minimum"
    ))
}
