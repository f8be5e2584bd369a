//! The gradient of f from the edges on Z(O).

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, zonogon_about, zonogon_area};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::runs::runs;
use crate::instances::polygons::{generator, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "linear-coefficient",
    place: Place { section: "4.1", label: "after the formula" },
    kind: ClaimKind::Statement,
    statement: "The linear coefficient of f in a region depends only on the edges of H that appear on Z(O)",
    code: &["zonotope::enclosing::min_area_zonogon"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Compares twice the turned sum of the edges of H on Z(O) with differences of f within the region.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 7);
    let mut tried = 0;
    for instance in polygons(&mut random, 60) {
        let polygon = &instance.polygon;
        let center = random_center(&mut random, polygon);
        if runs(polygon, &center).is_none() {
            continue;
        }
        let edges = edges_on_zonogon(polygon, &center);
        let gradient = edges.iter().fold(Point::at(0, 0), |sum, &t| {
            let edge = polygon[t].to(&polygon[(t + 1) % polygon.len()]);
            sum.plus(&integer(2), &Point::new(-edge.y, edge.x))
        });
        for direction in [Point::at(1, 0), Point::at(0, 1), Point::at(-3, 2)] {
            let Some(step) = step_within_region(polygon, &center, &direction, &edges) else {
                continue;
            };
            let moved = center.plus(&step, &direction);
            let change = zonogon_area(polygon, &moved) - zonogon_area(polygon, &center);
            let predicted = step * (&gradient.x * &direction.x + &gradient.y * &direction.y);
            if change != predicted {
                return Verdict::Refuted(format!("{} from {center} to {moved}", instance.name));
            }
            tried += 1;
        }
    }
    Verdict::Holds(format!(
        "{tried} differences of f within a region equal the step times 2 sum of (-y, x) over the edges (x, y) of H on \
            Z(O)"
    ))
}

/// The edges of H with both ends consecutive on Z(O).
fn edges_on_zonogon(polygon: &[Point], center: &Point) -> Vec<usize> {
    let zonogon = zonogon_about(polygon, center);
    (0..polygon.len())
        .filter(|&t| {
            zonogon
                .iter()
                .position(|vertex| *vertex == polygon[t])
                .is_some_and(|index| zonogon[(index + 1) % zonogon.len()] == polygon[(t + 1) % polygon.len()])
        })
        .collect()
}

/// A step that keeps the edges on Z(O), halved until it does.
fn step_within_region(polygon: &[Point], center: &Point, direction: &Point, edges: &[usize]) -> Option<RBig> {
    let mut step = integer(1);
    for _ in 0..40 {
        let moved = center.plus(&step, direction);
        if runs(polygon, &moved).is_some() && edges_on_zonogon(polygon, &moved) == edges {
            return Some(step);
        }
        step *= fraction(1, 2);
    }
    None
}
