//! In the plane, central symmetry is enough.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, convex_hull, zonogon_about};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::{generator, listed, polygons};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "planar-symmetric-is-zonogon",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "In the plane every centrally symmetric convex polygon is a zonogon",
    code: &["zonotope::zonotope"],
    figures: &["polygon-and-reflection"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Cuts symmetric polygons into half-edges, and takes the hull of all sums of the half-edges with both signs.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 1);
    let mut tried = 0;
    let mut largest = 0;
    for instance in polygons(&mut random, 60) {
        let center = instance.polygon[0].midpoint(&instance.polygon[1]);
        let symmetric = zonogon_about(&instance.polygon, &center);
        if symmetric.len() > 16 {
            continue;
        }
        let generators: Vec<Point> = half_edges(&symmetric);
        if sum_of_segments(&center, &generators) != symmetric {
            return Verdict::Refuted(format!("the symmetric polygon {}", listed(&symmetric)));
        }
        tried += 1;
        largest = largest.max(generators.len());
    }
    Verdict::Holds(format!(
        "{tried} centrally symmetric polygons equal the Minkowski sum of their half-edges, of up to {largest} segments"
    ))
}

/// Half of each edge of the first half of the boundary: edges that differ in sign are the same segment.
fn half_edges(symmetric: &[Point]) -> Vec<Point> {
    (0..symmetric.len() / 2)
        .map(|t| Point::at(0, 0).plus(&fraction(1, 2), &symmetric[t].to(&symmetric[t + 1])))
        .collect()
}

fn sum_of_segments(center: &Point, generators: &[Point]) -> Vec<Point> {
    let signs = [integer(1), integer(-1)];
    let mut sums = vec![center.clone()];
    for generator in generators {
        let ends = |point: &Point| signs.each_ref().map(|sign: &RBig| point.plus(sign, generator));
        sums = convex_hull(&sums.iter().flat_map(ends).collect::<Vec<_>>());
    }
    sums
}
