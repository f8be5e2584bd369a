//! Facets of a zonotope.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Facet, Vector};
use crate::instances::bodies::{bodies_in_general_position, degenerate_bodies};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "facets-are-parallelepipeds",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "A zonotope is a convex polytope whose facets are parallelepipeds spanned by (d-1)-tuples of generators",
    remedy: Some(
        "true when any d generators are independent; coplanar generators share one facet, a zonotope of dimension d-1",
    ),
    code: &["zonotope::zonotope::faces"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies in general position", "degenerate bodies"]),
    ..Claim::LISTED
};

/// In general position every facet is a parallelogram, and every pair of generators spans two; the truncated octahedron
/// has hexagons.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 33);
    let instances = bodies_in_general_position(&mut random, 35);
    let mut facets = 0;
    for instance in &instances {
        let body = instance.body();
        let all = body.facets();
        let n = body.generators.len();
        for facet in &all {
            let [i, j] = facet.spanning[..] else {
                return Verdict::Refuted(format!("{}: a facet of {} generators", instance.name, facet.spanning.len()));
            };
            let sides: Vec<Vector> = (0..4).map(|k| facet.corners[k].to(&facet.corners[(k + 1) % 4]).line()).collect();
            let spanning = [i, j].map(|index| body.generators[index].line());
            if facet.corners.len() != 4 || sides.iter().any(|side| !spanning.contains(side)) {
                return Verdict::Refuted(format!("{}: the facet with normal {}", instance.name, facet.normal));
            }
        }
        if all.len() != n * (n - 1) {
            return Verdict::Refuted(format!("{}: {} facets of {n} generators", instance.name, all.len()));
        }
        facets += all.len();
    }
    let truncated = degenerate_bodies().into_iter().find(|body| body.name == "the truncated octahedron");
    let hexagons = truncated.map_or(0, |instance| {
        let is_hexagon = |facet: &Facet| facet.corners.len() == 6 && facet.spanning.len() == 3;
        instance.body().facets().iter().filter(|facet| is_hexagon(facet)).count()
    });
    if hexagons != 8 {
        return Verdict::Inconclusive(format!("the truncated octahedron has {hexagons} hexagons"));
    }
    Verdict::Holds(format!(
        "all {facets} facets of {} bodies of 3 to 9 generators in general position are parallelograms of two \
         generators, two for each pair; without general position it fails: the truncated octahedron has {hexagons} \
         hexagons of three generators each",
        instances.len()
    ))
}
