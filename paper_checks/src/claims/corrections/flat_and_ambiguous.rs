//! Hulls without area, and minimisers that are not unique.

use zonotope::enclosing::min_area;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, convex_hull, least_area, signed_area, zonogon_area};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::{generator, random_polygon};
use crate::proofs::library::{doubles, encloses};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "flat-point-sets",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Note,
    statement: "The input can be assumed to be a convex polygon, and f has a global minimum at a vertex of the \
        arrangement",
    remedy: Some(
        "the assumption leaves out point sets without area: one point, two points and collinear points have no \
            arrangement: their zonogon is the segment, of area 0; and the minimiser need not be unique",
    ),
    code: &["zonotope::enclosing::min_area_zonogon"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Shows flat inputs that have no arrangement, and triangles, for which the whole medial triangle is optimal.
fn check(context: &CheckContext) -> Verdict {
    let flat: [&[(i64, i64)]; 4] =
        [&[(3, 4)], &[(3, 4), (3, 4)], &[(0, 0), (4, 2)], &[(0, 0), (2, 1), (6, 3), (4, 2), (2, 1)]];
    for coordinates in flat {
        let points: Vec<Point> = coordinates.iter().map(|&(x, y)| Point::at(x, y)).collect();
        let hull = convex_hull(&points);
        let middle = hull[0].midpoint(&hull[hull.len() - 1]);
        let answer = match min_area(&doubles(&points)) {
            Ok(answer) => answer,
            Err(error) => return Verdict::Inconclusive(format!("{points:?}: {error}")),
        };
        if zonogon_area(&points, &middle) != integer(0) || answer.value != 0.0 || !encloses(&answer, &points) {
            return Verdict::Inconclusive(format!("{points:?}: area {}", answer.value));
        }
    }

    let mut random = generator(context.seed, 19);
    for _ in 0..40 {
        let triangle = random_polygon(&mut random, 3, 50);
        if let Err(reason) = medial_triangle_is_optimal(&triangle) {
            return Verdict::Inconclusive(reason);
        }
    }
    Verdict::Holds(
        "one point, two points, collinear points with and without duplicates: no arrangement, area 0, the segment; 40 \
         triangles: f is twice the triangle's area at all three vertices of the arrangement and throughout the medial \
         triangle between them, and larger outside"
            .to_owned(),
    )
}

fn medial_triangle_is_optimal(triangle: &[Point]) -> Result<(), String> {
    let middles: Vec<Point> = (0..3).map(|t| triangle[t].midpoint(&triangle[(t + 1) % 3])).collect();
    let double = integer(2) * signed_area(triangle);
    let (least, mut minimizers) = least_area(triangle);
    let mut corners = middles.clone();
    corners.sort();
    minimizers.sort();
    if least != double || minimizers != corners {
        return Err(format!("{triangle:?}: least area {least} at {minimizers:?}"));
    }
    for third in 1..5 {
        let inside = middles[0]
            .midpoint(&middles[1])
            .plus(&fraction(third, 5), &middles[0].midpoint(&middles[1]).to(&middles[2]));
        if zonogon_area(triangle, &inside) != double {
            return Err(format!("{triangle:?}: f({inside}) is not twice the area"));
        }
    }
    let center = middles[0].midpoint(&middles[1]);
    for middle in &middles {
        let outside = center.plus(&fraction(-1, 3), &center.to(middle));
        if *middle != middles[0] && *middle != middles[1] && zonogon_area(triangle, &outside) <= double {
            return Err(format!("{triangle:?}: f({outside}) is not more than twice the area"));
        }
    }
    Ok(())
}
