//! Faces and the arrangement of great circles.

use std::collections::BTreeSet;

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::Vector;
use crate::instances::bodies::bodies;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "sphere-arrangement-duality",
    place: Place { section: "1", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "Outer normals map the faces of a zonotope to the arrangement of one great hypersphere per generator: \
        facets to vertices, a zone to the vertices of its hypersphere",
    code: &["zonotope::zonotope::faces"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// The outer normals of the facets are the points where circles cross; a facet has a side along a generator just when
/// its normal lies on the generator's circle; vertices are as many as cells, by Euler's formula on the sphere.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 36);
    let (mut solid, mut facets, mut cells) = (0, 0, 0);
    for instance in bodies(&mut random, 80) {
        let body = instance.body();
        if !body.holds_inside(&body.center) {
            continue;
        }
        solid += 1;
        let all = body.facets();
        for facet in &all {
            let sides: BTreeSet<Vector> = (0..facet.corners.len())
                .map(|k| facet.corners[k].to(&facet.corners[(k + 1) % facet.corners.len()]).line())
                .collect();
            for generator in body.generators.iter().filter(|generator| !generator.is_zero()) {
                let on_circle = facet.normal.dot(generator) == RBig::ZERO;
                if sides.contains(&generator.line()) != on_circle {
                    return Verdict::Refuted(format!("{}: {} and {generator}", instance.name, facet.normal));
                }
            }
        }
        // Around a vertex of the arrangement where k circles cross, 2k arcs end; each arc has two ends.
        let arcs: usize = all.iter().map(|facet| facet.corners.len()).sum::<usize>() / 2;
        let expected = 2 + arcs - all.len();
        let vertices = body.vertices().len();
        if vertices != expected {
            return Verdict::Refuted(format!("{}: {vertices} vertices, {expected} cells", instance.name));
        }
        facets += all.len();
        cells += vertices;
    }
    Verdict::Holds(format!(
        "{solid} bodies of full dimension, coplanar and parallel generators among them: the normals of {facets} facets \
         are the crossings of the circles, a facet has a side along a generator just when its normal is on that \
         circle, and the {cells} vertices are as many as the cells"
    ))
}
