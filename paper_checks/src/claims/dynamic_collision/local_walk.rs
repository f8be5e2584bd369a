//! Section 5.2, local walking method.

use zonotope::arrangement::facet_walk::{FacetWalk, HullWalk};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{bodies_in_general_position, degenerate_bodies, doubles, random_vector};
use crate::instances::polygons::generator;
use crate::proofs::facets::{named_facet, neighbours_of};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "local-walk",
    place: Place { section: "5.2", label: "local walking method" },
    kind: ClaimKind::Statement,
    statement: "Tracking the closest pair of features needs only the neighbours of a feature, which can be found from \
        the generators on the fly",
    code: &["zonotope::arrangement::facet_walk", "zonotope::collision::tracking"],
    figures: &["facet-walk", "tracked-features", "coherence"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies in general position", "degenerate bodies"]),
    ..Claim::LISTED
};

/// A walk knows its facet alone; its neighbours are those that share an edge with it by the definition, and going from
/// neighbour to neighbour it comes to the facet in which a ray leaves.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 88);
    let mut instances = bodies_in_general_position(&mut random, 21);
    instances.extend(degenerate_bodies());
    let (mut facets_seen, mut rays, mut steps, mut solid) = (0, 0, 0, 0);
    for instance in &instances {
        let rows: Vec<[f64; 3]> = instance.generators.iter().copied().map(doubles).collect();
        let Ok(mut walk) = HullWalk::new(&rows) else { continue };
        solid += 1;
        let body = Body::about_origin(&instance.generators);
        let facets = body.facets();
        for _ in 0..12 {
            let ray = random_vector(&mut random, 9);
            if ray == [0; 3] {
                continue;
            }
            let Ok(count) = walk.walk_to(doubles(ray)) else {
                return Verdict::Refuted(format!("{}: no way along {ray:?}", instance.name));
            };
            let Some(facet) = named_facet(&facets, &body, walk.facet()) else {
                return Verdict::Refuted(format!("{}: {:?} is no facet", instance.name, walk.facet()));
            };
            let ray = Vector::at(ray);
            let farthest = |normal: &Vector| normal.dot(&ray) / body.reach(normal);
            if facets.iter().any(|other| farthest(&other.normal) > farthest(&facet.normal)) {
                return Verdict::Refuted(format!("{}: {ray} does not leave by {:?}", instance.name, walk.facet()));
            }
            let found: Vec<_> = walk.neighbours().into_iter().map(|name| named_facet(&facets, &body, name)).collect();
            let truth = neighbours_of(&facets, facet);
            let is_right = found.len() == truth.len()
                && found.iter().all(|found| found.is_some_and(|found| truth.iter().any(|t| t.normal == found.normal)));
            if !is_right {
                return Verdict::Refuted(format!("{}: neighbours of {:?}", instance.name, walk.facet()));
            }
            (facets_seen, rays, steps) = (facets_seen + 1, rays + 1, steps + count);
        }
    }
    Verdict::Holds(format!(
        "{rays} walks of {steps} steps over {solid} bodies, coplanar and parallel generators among them, end in the \
         facet in which the ray leaves; all neighbours of {facets_seen} facets are those that share an edge with it"
    ))
}
