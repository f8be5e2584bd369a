//! Lemma 4.3: f is unimodal on every line.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Bisector, Point, bisectors, zonogon_area};
use crate::definitions::ratio::integer;
use crate::instances::polygons::{generator, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-4.3",
    place: Place { section: "4.1", label: "Lemma 4.3" },
    kind: ClaimKind::Lemma,
    statement: "On any line the slope of f never decreases, so that f is unimodal on it",
    code: &["zonotope::lad::of_lines::by_slope_selection"],
    figures: &["arrangement-and-level-sets"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Computes the slopes of f between its breaks from areas alone, and looks for one that falls.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 11);
    let (mut restrictions, mut pieces) = (0, 0);
    for instance in polygons(&mut random, 40) {
        let polygon = &instance.polygon;
        let lines = bisectors(polygon);
        let mut tested: Vec<(Point, Point)> = [(0, 1), (1, 0), (3, -2)]
            .into_iter()
            .map(|(x, y)| (random_center(&mut random, polygon), Point::at(x, y)))
            .collect();
        tested.extend(lines.iter().map(|line| (line.start.clone(), line.edge.clone())));
        for (through, direction) in tested {
            let slopes = slopes_along(polygon, &lines, &through, &direction);
            if slopes.windows(2).any(|pair| pair[0] > pair[1]) {
                return Verdict::Refuted(format!("{} along {direction} through {through}", instance.name));
            }
            restrictions += 1;
            pieces += slopes.len();
        }
    }
    Verdict::Holds(format!(
        "on {restrictions} lines, the lines l_t among them, the slopes of f over {pieces} pieces never decrease"
    ))
}

/// The slopes of f on the pieces between the crossings with the lines l_t, from two values of f on each.
fn slopes_along(polygon: &[Point], lines: &[Bisector], through: &Point, direction: &Point) -> Vec<RBig> {
    let mut breaks: Vec<RBig> = lines
        .iter()
        .filter(|line| line.edge.cross(direction) != RBig::ZERO)
        .map(|line| -line.height(through) / line.edge.cross(direction))
        .collect();
    breaks.sort();
    breaks.dedup();
    if let (Some(first), Some(last)) = (breaks.first().cloned(), breaks.last().cloned()) {
        breaks.insert(0, first - integer(1));
        breaks.push(last + integer(1));
    }
    let values: Vec<RBig> = breaks.iter().map(|along| zonogon_area(polygon, &through.plus(along, direction))).collect();
    (1..breaks.len())
        .map(|index| (&values[index] - &values[index - 1]) / (&breaks[index] - &breaks[index - 1]))
        .collect()
}
