//! The convex hull stands for the points.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};

use rand::RngExt;

use crate::definitions::plane::{Point, convex_hull, zonogon_about};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::{generator, random_point};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "hull-suffices",
    place: Place { section: "4", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "Only the convex hull of the geometry matters: a zonotope encloses the points iff it encloses their \
        hull",
    code: &["zonotope::hull"],
    check: Check::Run(check),
    tried: Tried::On(&["points of the plane"]),
    ..Claim::LISTED
};

/// Adds points inside the hull and looks whether any Z(O) changes.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 2);
    let mut compared = 0;
    for trial in 0..120 {
        let mut points: Vec<Point> = (0..3 + trial % 20).map(|_| random_point(&mut random, 9)).collect();
        if trial % 3 == 0 {
            let (first, second) = (points[0].clone(), points[1].clone());
            points.push(first.clone());
            points.push(first.plus(&fraction(random.random_range(0..=5), 5), &first.to(&second)));
        }
        let hull = convex_hull(&points);
        let center = random_point(&mut random, 9);
        if zonogon_about(&points, &center) != zonogon_about(&hull, &center) {
            return Verdict::Refuted(format!("{} points about {center}", points.len()));
        }
        compared += points.len() - hull.len();
    }
    let none = integer(0);
    let flat = [Point::at(0, 0), Point::new(none.clone(), none), Point::at(1, 2), Point::at(2, 4)];
    if zonogon_about(&flat, &flat[2]) != zonogon_about(&convex_hull(&flat), &flat[2]) {
        return Verdict::Refuted("collinear points with a duplicate".to_owned());
    }
    Verdict::Holds(format!(
        "Z(O) of 120 point sets is that of their hulls, {compared} inner, repeated or collinear points notwithstanding"
    ))
}
