//! Section 6, fourth to sixth paragraph.

use zonotope::motion::space_time::{Method, Sweep};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::space::Vector;
use crate::definitions::turning::Turning;
use crate::instances::sweeps::exact_body;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "radius-of-rotation",
    place: Place { section: "6", label: "fourth to sixth paragraph" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "The generators of P with v and the two of the square around the circle through the farthest arc end \
        bound P throughout the rigid motion",
    remedy: Some(
        "true when the body is rotated about the axis first and translated then, on any schedule; the radius is 2 r \
            sin(min(theta, 180 degrees)/2), r the largest distance of a vertex from the axis; a body that moves away \
            from the axis before it turns is not covered",
    ),
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// A point at (1, 0, 0) that moves by (10, 0, 0) and then turns by a quarter about the z axis.
fn check(_: &CheckContext) -> Verdict {
    let quarter = Turning {
        axis_point: Vector::at([0; 3]),
        axis: Vector::at([0, 0, 1]),
        half_tangent: integer(1),
        translation: Vector::at([10, 0, 0]),
    };
    let volume = Zonotope::new([1.0, 0.0, 0.0], vec![])
        .map_err(|error| error.to_string())
        .and_then(|point| {
            // an angle a little above the quarter turn
            let sweep = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 1.6, [10.0, 0.0, 0.0]);
            sweep.and_then(|sweep| point.swept_by(&sweep, Method::ByFarthestVertex)).map_err(|error| error.to_string())
        })
        .map(|volume| exact_body(&volume));
    let start = Vector::at([1, 0, 0]);
    let turned_first = quarter.placed_point(&integer(1), &integer(1), &start);
    let moved_first = quarter.turned(&integer(1), &start.plus(&integer(1), &quarter.translation));
    match volume {
        Err(reason) => Verdict::Inconclusive(reason),
        Ok(volume) if volume.holds(&turned_first) && !volume.holds(&moved_first) => Verdict::Refuted(format!(
            "a point at {start} that turns by a quarter about the z axis and then moves by {} ends in {turned_first}, \
             in the volume; one that moves first and turns about the same axis then ends in {moved_first}, outside",
            quarter.translation
        )),
        Ok(_) => Verdict::Inconclusive(format!("{turned_first} and {moved_first} are no witness")),
    }
}
