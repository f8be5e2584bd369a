//! Z(O) is the best zonogon about O.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, convex_hull, turn, zonogon_about};
use crate::definitions::ratio::integer;
use crate::instances::polygons::{generator, polygons, random_center};
use crate::proofs::library::{centered_zonogon, double};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "fixed-center-optimum",
    place: Place { section: "4.1", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "Among the zonogons centred at O that contain the points, the convex hull Z(O) of the points and their \
        reflections through O has the least area",
    code: &["zonotope::enclosing::centered_zonogon"],
    figures: &["polygon-and-reflection"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Checks the three facts that the optimum rests on: Z(O) is symmetric about O, it contains the points, and each of
/// its vertices is a point or a reflected point, so that every symmetric convex set about O with the points has it.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 3);
    let mut tried = 0;
    for instance in polygons(&mut random, 40) {
        let polygon = &instance.polygon;
        let mut centers: Vec<Point> = (0..4).map(|_| random_center(&mut random, polygon)).collect();
        centers.push(polygon[0].clone());
        centers.push(polygon[0].midpoint(&polygon[1]));
        for center in centers {
            let zonogon = zonogon_about(polygon, &center);
            let fails = zonogon.iter().any(|vertex| {
                let mirrored = vertex.reflected_through(&center);
                !zonogon.contains(&mirrored) || !(polygon.contains(vertex) || polygon.contains(&mirrored))
            });
            if fails || !polygon.iter().all(|point| contains(&zonogon, point)) {
                return Verdict::Refuted(format!("{} about {center}", instance.name));
            }
            let rounded = double(&center);
            let (built, _) = centered_zonogon(polygon, rounded);
            if convex_hull(&built) != zonogon_about(polygon, &Point::exactly(rounded)) {
                return Verdict::Refuted(format!("{}: the library has another Z(O) about {rounded:?}", instance.name));
            }
            tried += 1;
        }
    }
    Verdict::Holds(format!(
        "{tried} zonogons Z(O) are symmetric about O, contain the points and have only points and reflected points as \
         vertices; the library builds the same ones"
    ))
}

fn contains(polygon: &[Point], point: &Point) -> bool {
    (0..polygon.len()).all(|t| turn(&polygon[t], &polygon[(t + 1) % polygon.len()], point) >= integer(0))
}
