//! Section 5.1: the tiling as a subdivision of the plane.

use std::cmp::Ordering;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::instances::bodies::tilings;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "monotone-subdivision",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Statement,
    statement: "The tiling of the upper hull can be viewed as a monotone planar subdivision",
    code: &["zonotope::arrangement"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
    ..Claim::LISTED
};

/// Around a tile the boundary rises once and falls once, so that a horizontal line meets it in one piece.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 106);
    let instances = tilings(&mut random, 35);
    let mut tiles = 0;
    for (instance, _, facets) in &instances {
        for facet in facets {
            if turns(&facet.tile) != 2 {
                return Verdict::Refuted(format!("{}: the tile {:?}", instance.name, facet.pair));
            }
            tiles += 1;
        }
    }
    Verdict::Holds(format!(
        "the boundary of each of {tiles} tiles of {} tilings rises once and falls once",
        instances.len()
    ))
}

/// The number of times that the boundary of a polygon changes between rising and falling.
fn turns(polygon: &[Point]) -> usize {
    let next = |k: usize| &polygon[(k + 1) % polygon.len()];
    let steps = (0..polygon.len()).map(|k| next(k).y.cmp(&polygon[k].y));
    let steps: Vec<Ordering> = steps.filter(|step| step.is_ne()).collect();
    (0..steps.len()).filter(|&k| steps[k] != steps[(k + 1) % steps.len()]).count()
}
