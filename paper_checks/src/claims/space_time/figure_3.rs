//! Section 6, Figure 3.

use dashu_ratio::RBig;
use zonotope::motion::space_time::Method;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::Vector;
use crate::instances::polygons::generator;
use crate::instances::sweeps::{sign_points, square_sides, sweeps};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "figure-3",
    place: Place { section: "6", label: "Figure 3" },
    kind: ClaimKind::Figure,
    statement: "The arcs of the vertices of a rotating body, moved to a common origin, and the parallelogram around \
        them",
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    figures: &["paper-figure-3"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// Parts of an arc at whose ends a point of it is taken.
const PARTS: i64 = 8;

/// The square that the library adds is around the common origin and holds points of every arc, by exact products.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 170);
    let (mut squares, mut arcs, mut points) = (0, 0, 0);
    for moving in sweeps(&mut random, 40) {
        let (name, turning) = (&moving.instance.name, &moving.turning);
        let vertices = sign_points(&moving.instance.body());
        let farthest = vertices.iter().map(|vertex| turning.squared_distance(vertex)).max().unwrap_or(RBig::ZERO);
        let squared_radius = farthest * turning.squared_chord(&integer(1));
        if squared_radius == RBig::ZERO {
            continue;
        }
        let body = moving.instance.in_doubles();
        let volume = match body.swept_by(&moving.sweep, Method::ByFarthestVertex) {
            Ok(volume) => volume,
            Err(error) => return Verdict::Inconclusive(format!("{name}: {error}")),
        };
        let sides = square_sides(&volume, &body, &squared_radius);
        let [first, second] = &sides[..] else {
            return Verdict::Refuted(format!("{name}: {} sides are as long as the radius", sides.len()));
        };
        if first.dot(second) != integer(0) || [first, second].iter().any(|side| side.dot(&turning.axis) != integer(0)) {
            return Verdict::Refuted(format!("{name}: the sides are no square in the plane of the arcs"));
        }
        let is_held = |moved: &Vector| {
            [first, second].iter().all(|side| {
                let (along, most) = (moved.dot(side), side.dot(side));
                -&most <= along && along <= most
            })
        };
        for vertex in &vertices {
            let arm = turning.axis_point.to(vertex);
            for part in 0..=PARTS {
                let moved = arm.to(&turning.turned(&fraction(part, PARTS), &arm));
                if !is_held(&moved) {
                    return Verdict::Refuted(format!("{name}: the arc of {vertex} leaves the square"));
                }
                points += 1;
            }
            arcs += 1;
        }
        squares += 1;
    }
    Verdict::Holds(format!(
        "{points} points of {arcs} arcs, moved to a common origin, lie in the {squares} squares around it that the \
         library adds to the bodies"
    ))
}
