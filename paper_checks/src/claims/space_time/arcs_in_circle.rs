//! Section 6, fifth paragraph.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::generator;
use crate::instances::sweeps::{sign_points, sweeps};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "arcs-in-circle",
    place: Place { section: "6", label: "fifth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The arcs of the vertices, each below 180 degrees and moved to a common origin, lie in the circle whose \
        radius is the distance of the farthest end point, and so in a square of two generators",
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    figures: &["paper-figure-3"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// The points of every arc, seen from its beginning: orthogonal to the axis, as long as the formula of the chord says,
/// and none longer than the farthest end.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 164);
    let (mut bodies, mut arcs, mut points) = (0, 0, 0);
    for moving in sweeps(&mut random, 40) {
        let turning = &moving.turning;
        let vertices = sign_points(&moving.instance.body());
        let step = |eighths: i64, vertex| {
            let part = fraction(eighths, 8);
            let vector = turning.axis_point.to(vertex).to(&turning.turned(&part, &turning.axis_point.to(vertex)));
            (vector.dot(&vector), vector, part)
        };
        let farthest = vertices.iter().map(|vertex| step(8, vertex).0).max();
        for vertex in &vertices {
            for eighths in 0..=8 {
                let (square, vector, part) = step(eighths, vertex);
                let is_chord = square == turning.squared_chord(&part) * turning.squared_distance(vertex);
                if vector.dot(&turning.axis) != integer(0) || !is_chord || Some(&square) > farthest.as_ref() {
                    return Verdict::Refuted(format!("{}: the arc of {vertex}", moving.instance.name));
                }
                points += 1;
            }
            arcs += 1;
        }
        bodies += 1;
    }
    Verdict::Holds(format!(
        "{points} points of the {arcs} arcs of {bodies} turned bodies lie in the plane orthogonal to the axis, as far \
         from the arc's beginning as 2 sin(φ/2) times the distance from the axis, and none farther than the farthest \
         end; the square around a circle holds it"
    ))
}
