//! The zone of a generator.

use std::collections::BTreeMap;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Facet, Vector};
use crate::instances::bodies::bodies_in_general_position;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "zones-are-bands",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "In R^3 the facets that share a generator form a band around the zonotope",
    code: &["zonotope::zonotope::faces"],
    figures: &["named-zonohedra"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
    ..Claim::LISTED
};

/// Walks from facet to facet across edges parallel to the generator: the walk meets every facet of the zone once and
/// closes.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 35);
    let (mut zones, mut steps) = (0, 0);
    for instance in bodies_in_general_position(&mut random, 35) {
        let body = instance.body();
        let facets = body.facets();
        for generator in 0..body.generators.len() {
            let zone: Vec<&Facet> = facets.iter().filter(|facet| facet.spanning.contains(&generator)).collect();
            match band_length(&zone, &body.generators[generator].line()) {
                Some(length) if length == zone.len() && length == 2 * (body.generators.len() - 1) => steps += length,
                length => {
                    return Verdict::Refuted(format!(
                        "{}: the zone of generator {generator} has {} facets, the walk {length:?}",
                        instance.name,
                        zone.len()
                    ));
                }
            }
            zones += 1;
        }
    }
    Verdict::Holds(format!(
        "in {zones} zones of bodies in general position the {steps} facets form one closed band each, of 2(n-1) facets \
         joined along the edges parallel to the generator"
    ))
}

/// The number of facets that a walk across the edges of this direction meets before it returns to the first; `None` if
/// an edge has not two facets.
fn band_length(zone: &[&Facet], direction: &Vector) -> Option<usize> {
    let mut sharing: BTreeMap<[Vector; 2], Vec<usize>> = BTreeMap::new();
    for (index, facet) in zone.iter().enumerate() {
        for edge in edges_along(facet, direction) {
            sharing.entry(edge).or_default().push(index);
        }
    }
    let (mut here, mut entered) = (0, None);
    for length in 1..=zone.len() {
        let exit = edges_along(zone[here], direction).into_iter().find(|edge| entered.as_ref() != Some(edge))?;
        let [one, other] = sharing.get(&exit)?[..] else { return None };
        here = if one == here { other } else { one };
        entered = Some(exit);
        if here == 0 {
            return Some(length);
        }
    }
    None
}

fn edges_along(facet: &Facet, direction: &Vector) -> Vec<[Vector; 2]> {
    let count = facet.corners.len();
    let edges = (0..count).map(|k| [facet.corners[k].clone(), facet.corners[(k + 1) % count].clone()]);
    edges
        .filter(|[from, to]| from.to(to).line() == *direction)
        .map(|mut edge| {
            edge.sort();
            edge
        })
        .collect()
}
