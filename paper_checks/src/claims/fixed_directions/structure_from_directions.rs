//! Section 4.2, second paragraph.

use std::collections::BTreeSet;

use rand::RngExt;
use zonotope::zonotope::combinatorics;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{BodyInstance, bodies, bodies_in_general_position};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "structure-from-directions",
    place: Place { section: "4.2", label: "second paragraph" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "The combinatorial structure of a zonotope depends on the directions of its generators and not on their \
        lengths",
    remedy: Some(
        "true of lengths above zero; the program of 4.2 gives zero coefficients, and each of them takes faces away",
    ),
    code: &["zonotope::zonotope::faces", "zonotope::enclosing::fixed_directions"],
    figures: &["mesh-in-zonohedra"],
    check: Check::Run(check),
    tried: Tried::Witness,
};

/// Bodies with their generators stretched by random factors: the same facets meet in the same vertices, until a factor
/// is zero.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 60);
    let (mut tried, mut lost) = (0, 0);
    for mut instance in bodies_in_general_position(&mut random, 14).into_iter().chain(bodies(&mut random, 40)) {
        let body = instance.body();
        if !body.holds_inside(&body.center) || body.generators.len() > 7 {
            continue;
        }
        let (before, counts) = (incidences(&body), library_counts(&instance));
        for generator in &mut instance.generators {
            let factor = random.random_range(1..10);
            *generator = generator.map(|c| c * factor);
        }
        if incidences(&instance.body()) != before {
            return Verdict::Refuted(format!("{}: stretched, other facets meet", instance.name));
        }
        if library_counts(&instance) != counts {
            return Verdict::Inconclusive(format!("{}: the library's counts change with the lengths", instance.name));
        }
        tried += 1;
        instance.generators[0] = [0; 3];
        lost += usize::from(library_counts(&instance) != counts);
    }
    if lost == 0 {
        return Verdict::Inconclusive(format!("a factor of zero changes the counts in none of {tried} bodies"));
    }
    Verdict::Refuted(format!(
        "in {tried} bodies of R^3, parallel and coplanar generators among them, the facets that meet in each vertex \
         stay the same when every generator is stretched by a factor of its own; a factor of zero changes the counts \
         in {lost} of them"
    ))
}

/// For each vertex the normals of the facets that meet in it.
fn incidences(body: &Body) -> BTreeSet<BTreeSet<Vector>> {
    let facets = body.facets();
    let meeting = |vertex: &Vector| {
        facets.iter().filter(|facet| facet.corners.contains(vertex)).map(|facet| facet.normal.clone()).collect()
    };
    body.vertices().iter().map(meeting).collect()
}

fn library_counts(instance: &BodyInstance) -> [u64; 3] {
    let counted = combinatorics(&instance.in_doubles());
    [counted.vertices, counted.edges, counted.facets]
}
