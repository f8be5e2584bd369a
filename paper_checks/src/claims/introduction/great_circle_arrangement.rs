//! Faces and the arrangement of great circles.

use std::collections::BTreeSet;

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::signs::{Signs, cells, faces, lies_in};
use crate::definitions::space::Vector;
use crate::instances::bodies::bodies;
use crate::instances::higher::spanning;
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
    tried: Tried::On(&["bodies of R^3", "bodies of R^4", "bodies of R^5"]),
    ..Claim::LISTED
};

/// The outer normals of the facets are the points where circles cross; a facet has a side along a generator just when
/// its normal lies on the generator's circle; vertices are as many as cells, by Euler's formula on the sphere.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 36);
    let (mut solid, mut facets, mut seen) = (0, 0, 0);
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
        seen += vertices;
    }
    match [higher::<4>(context.seed, 117), higher::<5>(context.seed, 118)] {
        [Ok(four), Ok(five)] => Verdict::Holds(format!(
            "{solid} bodies of R^3 of full dimension, coplanar and parallel generators among them: the normals of \
             {facets} facets are the crossings of the circles, a facet has a side along a generator just when its \
             normal is on that circle, and the {seen} vertices are as many as the cells; the same of {four} and {five}"
        )),
        [Err(witness), _] | [_, Err(witness)] => Verdict::Refuted(witness),
    }
}

/// A facet has an edge along a generator just when its normal is on that hypersphere; the vertices are as many as the
/// cells, which are counted by taking the hyperspheres away one by one.
fn higher<const D: usize>(seed: u64, stream: u64) -> Result<String, String> {
    let instances = spanning::<D>(&mut generator(seed, stream), 24);
    let (mut facets, mut vertices) = (0, 0);
    for instance in &instances {
        let by_dimension = faces(&instance.rows(), D);
        for facet in &by_dimension[D - 1] {
            let edges: Vec<&Signs> = by_dimension[1].iter().filter(|edge| lies_in(edge, facet)).collect();
            let has_edge = |index: usize| edges.iter().any(|edge| edge[index] == 0);
            if (0..facet.len()).any(|index| has_edge(index) != (facet[index] == 0)) {
                return Err(format!("{:?} in R^{D}: the edges of the facet {facet:?}", instance.generators));
            }
        }
        if by_dimension[0].len() != cells(&instance.rows()) {
            return Err(format!("{:?} in R^{D}: {} vertices", instance.generators, by_dimension[0].len()));
        }
        facets += by_dimension[D - 1].len();
        vertices += by_dimension[0].len();
    }
    Ok(format!("{facets} facets and {vertices} vertices of {} bodies of R^{D}", instances.len()))
}
