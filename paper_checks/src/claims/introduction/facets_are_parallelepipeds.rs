//! Facets of a zonotope.

use std::collections::BTreeMap;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::subsets;
use crate::definitions::signs::{faces, lies_in};
use crate::definitions::space::{Facet, Vector};
use crate::instances::bodies::{bodies_in_general_position, degenerate_bodies};
use crate::instances::higher::spanning;
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
    tried: Tried::On(&["bodies of R^3", "bodies of R^4", "bodies of R^5"]),
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
    match [higher::<4>(context.seed, 115), higher::<5>(context.seed, 116)] {
        [Ok(four), Ok(five)] => Verdict::Holds(format!(
            "all {facets} facets of {} bodies of 3 to 9 generators in general position are parallelograms of two \
             generators, two for each pair; {four} and {five} are parallelepipeds of D - 1 generators, two for each \
             choice; without general position it fails: the truncated octahedron has {hexagons} hexagons of three \
             generators each",
            instances.len()
        )),
        [Err(witness), _] | [_, Err(witness)] => Verdict::Refuted(witness),
    }
}

/// In general position a facet has D − 1 generators along it and a vertex for each choice of their signs, and each
/// choice of D − 1 generators has two facets.
fn higher<const D: usize>(seed: u64, stream: u64) -> Result<String, String> {
    let instances = spanning::<D>(&mut generator(seed, stream), 24);
    let (mut bodies, mut facets) = (0, 0);
    for instance in instances.iter().filter(|instance| instance.is_general) {
        let by_dimension = faces(&instance.rows(), D);
        let mut spanned: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
        for facet in &by_dimension[D - 1] {
            let along: Vec<usize> = (0..facet.len()).filter(|&index| facet[index] == 0).collect();
            let corners = by_dimension[0].iter().filter(|vertex| lies_in(vertex, facet)).count();
            if along.len() != D - 1 || corners != 1 << (D - 1) {
                return Err(format!("{:?} in R^{D}: a facet {facet:?} of {corners} vertices", instance.generators));
            }
            *spanned.entry(along).or_default() += 1;
        }
        let mut choices = 0;
        subsets(instance.generators.len(), D - 1, &mut |_| choices += 1);
        if spanned.len() != choices || spanned.values().any(|&count| count != 2) {
            return Err(format!(
                "{:?} in R^{D}: {} sets of generators have facets",
                instance.generators,
                spanned.len()
            ));
        }
        bodies += 1;
        facets += by_dimension[D - 1].len();
    }
    Ok(format!("all {facets} of {bodies} bodies of R^{D}"))
}
