//! Section 6, sixth paragraph.

use dashu_ratio::RBig;
use zonotope::motion::space_time::Method;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{exactly, integer};
use crate::definitions::space::Vector;
use crate::instances::polygons::generator;
use crate::instances::sweeps::{sign_points, sweeps};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "farthest-vertex-from-axis",
    place: Place { section: "6", label: "sixth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The vertex farthest from the rotation axis is found from the zonogon of the projected generators in \
        O(n log n) time",
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// A half-side of the library's square may exceed the exact radius by this part of it.
const EXCESS: f64 = 1e-12;

/// The half-side of the square that the library adds is the radius by all choices of signs, rounded up.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 165);
    let (mut bodies, mut vertices) = (0, 0);
    for moving in sweeps(&mut random, 60) {
        let body = moving.instance.in_doubles();
        let points = sign_points(&moving.instance.body());
        let distance = points.iter().map(|point| moving.turning.squared_distance(point)).max();
        let exact = distance.unwrap_or(RBig::ZERO) * moving.turning.squared_chord(&integer(1));
        if exact == RBig::ZERO {
            continue;
        }
        let volume = match body.swept_by(&moving.sweep, Method::ByFarthestVertex) {
            Ok(volume) => volume,
            Err(error) => return Verdict::Inconclusive(format!("{}: {error}", moving.instance.name)),
        };
        // the two sides of the square are the added generators as long as the radius
        let most = &exact * (integer(1) + exactly(EXCESS));
        let sides = volume.generators()[body.generators().len()..].iter().map(|side| Vector::exactly(*side));
        let found = sides.map(|side| side.dot(&side)).filter(|square| *square >= exact && *square <= most).count();
        if found != 2 {
            return Verdict::Refuted(format!("{}: {found} sides are as long as the radius", moving.instance.name));
        }
        bodies += 1;
        vertices += points.len();
    }
    Verdict::InPart(format!(
        "for {bodies} turned bodies the half-side of the square is the distance that the farthest of all {vertices} \
         points center ± g_1 ± … ± g_n moves, but for rounding upwards by less than {EXCESS:e} of it; the number of \
         operations is not counted"
    ))
}
