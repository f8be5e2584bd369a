//! Section 6, fourth paragraph.

use zonotope::motion::space_time::Method;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::bodies::random_member;
use crate::instances::polygons::generator;
use crate::instances::sweeps::{exact_body, sign_points, sweeps};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "placements-by-vertices",
    place: Place { section: "6", label: "fourth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The volume contains all vertices of each placement of P during the rotation, and so, by convexity, \
        all of P throughout the interval",
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    figures: &["swept-volumes"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// The points of every choice of signs and other members of placements, point by point.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 163);
    let (mut bodies, mut corners, mut members) = (0, 0, 0);
    for moving in sweeps(&mut random, 8) {
        let body = moving.instance.body();
        if body.generators.len() > 4 {
            continue;
        }
        let volume = match moving.instance.in_doubles().swept_by(&moving.sweep, Method::ByFarthestVertex) {
            Ok(volume) => exact_body(&volume),
            Err(error) => return Verdict::Inconclusive(format!("{}: {error}", moving.instance.name)),
        };
        for part in [1, 2].map(|halves| fraction(halves, 2)) {
            let placed = moving.turning.placed(&part, &integer(0), &body);
            let vertices = sign_points(&placed);
            let others: Vec<_> = (0..3).map(|_| random_member(&mut random, &placed)).collect();
            if let Some(outside) = vertices.iter().chain(&others).find(|point| !volume.holds(point)) {
                return Verdict::Refuted(format!("{}: {outside} is outside", moving.instance.name));
            }
            corners += vertices.len();
            members += others.len();
        }
        bodies += 1;
    }
    Verdict::Holds(format!(
        "{corners} points center ± g_1 ± … ± g_n of placements of {bodies} turned bodies, the vertices among them, and \
         {members} other points of these placements lie in the volumes"
    ))
}
