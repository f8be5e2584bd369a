//! Section 5.1: the length of a separator.

use dashu_ratio::RBig;
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::separator::separator;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::upper_hull::project;
use crate::instances::bodies::doubles;
use crate::instances::bodies::tilings;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "separator-length",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Statement,
    statement: "Each separator consists of n line segments",
    code: &["zonotope::arrangement::separator"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
    ..Claim::LISTED
};

/// Every chain has one segment along each projected generator.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 107);
    let instances = tilings(&mut random, 35);
    let mut chains = 0;
    for (instance, body, facets) in &instances {
        let rows: Vec<[f64; 3]> = instance.generators.iter().copied().map(doubles).collect();
        let Ok(dual) = DualArrangement::new(&rows) else {
            return Verdict::Inconclusive(format!("{} has no dual arrangement", instance.name));
        };
        let projections: Vec<Point> = body.generators.iter().map(project).collect();
        for k in 0..=facets.len() as u64 {
            let Ok(chain) = separator(&dual, k, context.seed, &mut ()) else {
                return Verdict::Inconclusive(format!("{} has no separator {k}", instance.name));
            };
            let points: Vec<Point> = chain.rational_points().into_iter().map(|[x, y]| Point::new(x, y)).collect();
            let segments: Vec<Point> = points.windows(2).map(|pair| pair[0].to(&pair[1])).collect();
            let one_along =
                |vector: &Point| segments.iter().filter(|segment| segment.cross(vector) == RBig::ZERO).count() == 1;
            if segments.len() != projections.len() || !projections.iter().all(one_along) {
                return Verdict::Refuted(format!("{}: separator {k}", instance.name));
            }
            chains += 1;
        }
    }
    Verdict::Holds(format!(
        "{chains} separators of {} tilings have n segments, one along each projected generator",
        instances.len()
    ))
}
