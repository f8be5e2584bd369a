//! Section 6, sixth paragraph.

use dashu_ratio::RBig;
use experiments::fit::GrowthModel;
use zonotope::motion::space_time::Method;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::growth;
use crate::instances::polygons::generator;
use crate::instances::sweeps::{RADIUS_EXCESS, sign_points, square_sides, sweeps, volume_operations};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "farthest-vertex-from-axis",
    place: Place { section: "6", label: "sixth paragraph" },
    kind: ClaimKind::Statement,
    statement: "The vertex farthest from the rotation axis is found from the zonogon of the projected generators in \
        O(n log n) time",
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    check: Check::Run(check),
    tried: Tried::Growth(&["random bodies"]),
    ..Claim::LISTED
};

/// The half-side of the square that the library adds is the radius by all choices of signs, rounded up; operations fit
/// n log n.
fn check(context: &CheckContext) -> Verdict {
    growth::verdict(context, &CLAIM, radius_evidence(context), growth_evidence, &["by_farthest_vertex"])
}

fn radius_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 165);
    let (mut bodies, mut vertices) = (0, 0);
    for moving in sweeps(&mut random, 60) {
        let name = &moving.instance.name;
        let body = moving.instance.in_doubles();
        let points = sign_points(&moving.instance.body());
        let distance = points.iter().map(|point| moving.turning.squared_distance(point)).max();
        let exact = distance.unwrap_or(RBig::ZERO) * moving.turning.squared_chord(&integer(1));
        if exact == RBig::ZERO {
            continue;
        }
        let volume =
            body.swept_by(&moving.sweep, Method::ByFarthestVertex).map_err(|error| format!("{name}: {error}"))?;
        let found = square_sides(&volume, &body, &exact).len();
        if found != 2 {
            return Err(format!("{name}: {found} sides are as long as the radius"));
        }
        bodies += 1;
        vertices += points.len();
    }
    Ok(format!(
        "for {bodies} turned bodies the half-side of the square is the distance that the farthest of all {vertices} \
         points center ± g_1 ± … ± g_n moves, but for rounding upwards by less than {RADIUS_EXCESS:e} of it"
    ))
}

fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let samples = volume_operations(&mut generator(context.seed, 168))?;
    growth::evidence("the farthest vertex", &samples, GrowthModel::Linearithmic)
}
