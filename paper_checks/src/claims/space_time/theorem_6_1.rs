//! Section 6, Theorem 6.1.

use experiments::fit::GrowthModel;
use zonotope::motion::space_time::Method;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::fraction;
use crate::definitions::space::Body;
use crate::growth;
use crate::instances::polygons::generator;
use crate::instances::sweeps::{SweepInstance, exact_body, sweeps, volume_operations};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-6.1",
    place: Place { section: "6", label: "Theorem 6.1" },
    kind: ClaimKind::Theorem,
    statement: "Three generators added to P, computed in O(n log n) time, give a zonotope that bounds all placements \
        of P during a rigid motion",
    remedy: Some(
        "with v/2 in place of v where generators are half-lengths, and for motions that turn the body about the axis \
            first and translate it then; see the corrections",
    ),
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    figures: &["paper-figure-3", "swept-volumes"],
    check: Check::Run(check),
    tried: Tried::Growth(&["random bodies"]),
};

/// Every placement of a grid of angles and translations lies in the library's volume, by exact normals; operations fit
/// n log n.
fn check(context: &CheckContext) -> Verdict {
    growth::verdict(context, &CLAIM, placement_evidence(context), growth_evidence, &["by_farthest_vertex"])
}

fn placement_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 161);
    let (mut volumes, mut placements, mut most_added) = (0, 0, 0);
    for moving in sweeps(&mut random, 24) {
        let name = &moving.instance.name;
        let body = moving.instance.in_doubles();
        let volume =
            body.swept_by(&moving.sweep, Method::ByFarthestVertex).map_err(|error| format!("{name}: {error}"))?;
        let placed = grid(&moving);
        if let Some(outside) = exact_body(&volume).first_outside(&placed) {
            return Err(format!("{name}: the placement about {} sticks out", outside.center));
        }
        volumes += 1;
        placements += placed.len();
        most_added = most_added.max(volume.generators().len() - body.generators().len());
    }
    Ok(format!(
        "{placements} placements of {volumes} moving bodies lie in their volumes, by exact support values along all \
         facet normals; at most {most_added} generators are added, three of them the theorem's, the others along the \
         axes for what rounding lost"
    ))
}

fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let samples = volume_operations(&mut generator(context.seed, 169))?;
    growth::evidence("the volume", &samples, GrowthModel::Linearithmic)
}

/// Placements by parts of the angle and, independently, of the translation: no schedule is assumed.
fn grid(moving: &SweepInstance) -> Vec<Body> {
    let body = moving.instance.body();
    let parts = [0, 1, 2, 4].map(|quarters| fraction(quarters, 4));
    let moved = [0, 1, 3].map(|thirds| fraction(thirds, 3));
    parts.iter().flat_map(|part| moved.iter().map(|moved| moving.turning.placed(part, moved, &body))).collect()
}
