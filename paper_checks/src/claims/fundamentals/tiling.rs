//! The tiling of Q.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, convex_hull, signed_area, turn};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::upper_hull::project;
use crate::instances::bodies::{bodies_in_general_position, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "upper-hull-tiling",
    place: Place { section: "3", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "In R^3 the upper hull projects to a tiling of a convex polygon Q by translates of the parallelograms \
        of the projected generators, one for each pair",
    remedy: Some("in general position: parallel projections have no tile, coplanar generators share one"),
    code: &["zonotope::arrangement"],
    figures: &["paper-figure-1", "duality-family"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
};

/// The facets that look up: one for each pair, of the pair's shape; their areas add up to that of Q, and points of Q
/// lie in one of them.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 42);
    let (mut tilings, mut tiles, mut points) = (0, 0, 0);
    for instance in bodies_in_general_position(&mut random, 35) {
        let body = instance.body();
        let projected: Vec<Point> = body.generators.iter().map(project).collect();
        if pairs(projected.len()).any(|(i, j)| projected[i].cross(&projected[j]) == RBig::ZERO) {
            continue;
        }
        let upper: Vec<_> = body.facets().into_iter().filter(|facet| facet.normal.0[2] > RBig::ZERO).collect();
        let corners: Vec<Vec<Point>> = upper.iter().map(|facet| facet.corners.iter().map(project).collect()).collect();
        let mut spanning: Vec<(usize, usize)> =
            upper.iter().map(|facet| (facet.spanning[0], facet.spanning[1])).collect();
        spanning.sort_unstable();
        let mut wanted: Vec<(usize, usize)> = pairs(projected.len()).collect();
        wanted.sort_unstable();
        let shapes_agree = upper.iter().zip(&corners).all(|(facet, tile)| {
            let cross = projected[facet.spanning[0]].cross(&projected[facet.spanning[1]]);
            let area = if cross < RBig::ZERO { -cross } else { cross } * integer(4);
            signed_area(tile) == area
        });
        let all: Vec<Point> = corners.iter().flatten().cloned().collect();
        let q = convex_hull(&all);
        let total = corners.iter().fold(RBig::ZERO, |sum, tile| sum + signed_area(tile));
        if spanning != wanted || !shapes_agree || total != signed_area(&q) {
            return Verdict::Refuted(instance.name);
        }
        for _ in 0..20 {
            let [x, y, _] = random_vector(&mut random, 60);
            let point = project(&body.center).plus(&fraction(1, 7), &Point::at(x, y));
            let holding = corners.iter().filter(|tile| holds(tile, &point)).count();
            let strictly = corners.iter().filter(|tile| strictly_holds(tile, &point)).count();
            if (holding > 0) != holds(&q, &point) || strictly > 1 || (strictly == 1 && holding > 1) {
                return Verdict::Refuted(format!("{}: {point} lies in {holding} tiles", instance.name));
            }
            points += 1;
        }
        tilings += 1;
        tiles += upper.len();
    }
    Verdict::Holds(format!(
        "{tilings} bodies in general position: {tiles} facets look up, one for each pair of generators and with the \
         pair's area, the areas add up to that of Q, and {points} points lie in a tile just when they lie in Q, in the \
         interior of at most one"
    ))
}

fn pairs(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count).flat_map(|j| (0..j).map(move |i| (i, j)))
}

fn holds(polygon: &[Point], point: &Point) -> bool {
    (0..polygon.len()).all(|k| turn(&polygon[k], &polygon[(k + 1) % polygon.len()], point) >= RBig::ZERO)
}

fn strictly_holds(polygon: &[Point], point: &Point) -> bool {
    (0..polygon.len()).all(|k| turn(&polygon[k], &polygon[(k + 1) % polygon.len()], point) > RBig::ZERO)
}
