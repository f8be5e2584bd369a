//! Lemma 4.1: f is piecewise affine over the arrangement of the lines l_t.

use std::collections::BTreeMap;

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Bisector, Point, bisectors, cell, cell_gradient, hinge_sum, zonogon_area};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::{generator, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-4.1",
    place: Place { section: "4.1", label: "Lemma 4.1" },
    kind: ClaimKind::Lemma,
    statement: "The area function f is piecewise affine over the arrangement of the n lines l_t",
    code: &["zonotope::enclosing::bisectors", "zonotope::enclosing::min_area_zonogon"],
    figures: &["arrangement-and-level-sets"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Compares f with the hinge sum everywhere, with one affine function on each cell, and across each line.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 9);
    let (mut values, mut cells, mut bends) = (0, 0, 0);
    for instance in polygons(&mut random, 40) {
        let polygon = &instance.polygon;
        let lines = bisectors(polygon);
        let f = |center: &Point| zonogon_area(polygon, center);
        let constant = f(&polygon[0]) - hinge_sum(&lines, &polygon[0]);
        let mut centers: Vec<Point> = (0..40).map(|_| random_center(&mut random, polygon)).collect();
        centers.extend(lines.iter().map(|line| line.start.clone()));

        let mut first_of_cell: BTreeMap<_, (Point, RBig)> = BTreeMap::new();
        for center in centers {
            let value = f(&center);
            if value != &constant + hinge_sum(&lines, &center) {
                return Verdict::Refuted(format!("{}: f({center}) is not the hinge sum", instance.name));
            }
            values += 1;
            let name = cell(&lines, &center);
            if let Some((other, other_value)) = first_of_cell.get(&name) {
                let gradient = cell_gradient(&lines, &center);
                let step = other.to(&center);
                let predicted = other_value + &gradient.x * &step.x + &gradient.y * &step.y;
                if predicted != value {
                    return Verdict::Refuted(format!("{}: f is not affine from {other} to {center}", instance.name));
                }
            } else {
                first_of_cell.insert(name, (center, value));
            }
        }
        cells += first_of_cell.len();
        for line in &lines {
            if !bends_across(f, line) {
                return Verdict::Refuted(format!("{}: f is affine across a line l_t", instance.name));
            }
            bends += 1;
        }
    }
    Verdict::Holds(format!(
        "{values} values of f equal C + 2 sum of max(0, e_t x (O - m_t)); f is affine on each of {cells} faces met, \
         and bends across each of the {bends} lines, one for each edge"
    ))
}

/// Whether f at a point of the line is below the mean of its values on either side, close by.
fn bends_across(f: impl Fn(&Point) -> RBig, line: &Bisector) -> bool {
    let across = line.gradient();
    let (left, right) = (line.start.plus(&fraction(1, 1000), &across), line.start.plus(&fraction(-1, 1000), &across));
    integer(2) * f(&line.start) < f(&left) + f(&right)
}
