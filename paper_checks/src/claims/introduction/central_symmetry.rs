//! Central symmetry of a zonotope and of its boundary.

use std::collections::BTreeSet;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::signs::{Signs, faces, lies_in};
use crate::definitions::space::Vector;
use crate::instances::bodies::bodies;
use crate::instances::higher::spanning;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "central-symmetry",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Every zonotope is centrally symmetric, and every facet has an opposite congruent one",
    code: &["zonotope::zonotope::faces"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies of R^3", "bodies of R^4", "bodies of R^5"]),
    ..Claim::LISTED
};

/// Reflects each facet through the centre and looks for the reflection among the facets; a reflection is a congruence.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 34);
    let (mut solid, mut facets) = (0, 0);
    for instance in bodies(&mut random, 60) {
        let body = instance.body();
        let all = body.facets();
        if !body.holds_inside(&body.center) {
            continue;
        }
        solid += 1;
        let reflected = |point: &Vector| body.center.plus(&integer(-1), &body.center.to(point));
        for facet in &all {
            let mut wanted: Vec<Vector> = facet.corners.iter().map(reflected).collect();
            wanted.sort();
            let opposite = all.iter().any(|other| {
                let mut corners = other.corners.clone();
                corners.sort();
                corners == wanted && other.normal == facet.normal.to(&Vector::at([0; 3]))
            });
            if !opposite {
                return Verdict::Refuted(format!("{}: the facet with normal {}", instance.name, facet.normal));
            }
            facets += 1;
        }
    }
    match [higher::<4>(context.seed, 119), higher::<5>(context.seed, 120)] {
        [Ok(four), Ok(five)] => Verdict::Holds(format!(
            "each of the {facets} facets of {solid} bodies of R^3 of full dimension, {four} and {five}, reflected \
             through the centre, is the facet with the opposite normal"
        )),
        [Err(witness), _] | [_, Err(witness)] => Verdict::Refuted(witness),
    }
}

/// Reflects the vertices of each facet, as points, and looks for the facet that has the reflections.
fn higher<const D: usize>(seed: u64, stream: u64) -> Result<String, String> {
    let instances = spanning::<D>(&mut generator(seed, stream), 16);
    let mut facets = 0;
    for instance in &instances {
        let by_dimension = faces(&instance.rows(), D);
        let point = |vertex: &Signs| -> [i64; D] {
            let along =
                |axis: usize| vertex.iter().zip(&instance.generators).map(move |(&s, g)| i64::from(s) * g[axis]);
            std::array::from_fn(|axis| along(axis).sum())
        };
        let corners = |facet: &Signs| -> BTreeSet<[i64; D]> {
            by_dimension[0].iter().filter(|vertex| lies_in(vertex, facet)).map(point).collect()
        };
        let all: BTreeSet<BTreeSet<[i64; D]>> = by_dimension[D - 1].iter().map(corners).collect();
        let reflected = |facet: &BTreeSet<[i64; D]>| facet.iter().map(|corner| corner.map(|c| -c)).collect();
        if let Some(facet) = all.iter().find(|facet| !all.contains(&reflected(facet))) {
            return Err(format!("{:?} in R^{D}: the facet of {facet:?}", instance.generators));
        }
        facets += all.len();
    }
    Ok(format!("the {facets} of {} bodies of R^{D}", instances.len()))
}
