//! Section 5.2, proof of Lemma 5.5.

use zonotope::reduction::by_patches::patches_within;
use zonotope::reduction::contains;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{BodyInstance, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.5-containment",
    place: Place { section: "5.2", label: "proof of Lemma 5.5" },
    kind: ClaimKind::Statement,
    statement: "The approximation B of the proof contains A",
    code: &["zonotope::reduction::by_patches"],
    figures: &["reductions"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies"]),
    ..Claim::LISTED
};

/// The precision: a part of the diameter.
const EPSILON: f64 = 0.9;

/// The number of generators of the bodies: enough for some patches to have several.
const GENERATORS: usize = 150;

/// Approximates bodies of many generators and holds them against the approximation along each of its facet normals.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 71);
    let mut counts = Vec::new();
    for reach in [2, 3, 20, 1000] {
        let rows = (0..GENERATORS).map(|_| random_vector(&mut random, reach)).collect();
        let instance =
            BodyInstance { name: format!("the body of reach {reach}"), center: [reach, 0, -1], generators: rows };
        let body = instance.in_doubles();
        let Ok(found) = patches_within(&body, EPSILON, &mut ()) else {
            return Verdict::Inconclusive(format!("{} is refused", instance.name));
        };
        let generators = found.body.generators();
        let outer = Body {
            center: Vector::exactly(found.body.center()),
            generators: generators.iter().map(|g| Vector::exactly(*g)).collect(),
        };
        let inner = instance.body();
        let reaches = outer.normals().iter().all(|normal| inner.support(normal) <= outer.support(normal));
        if !reaches || contains(&found.body, &body) != Some(true) {
            return Verdict::Refuted(instance.name);
        }
        if generators.len() >= GENERATORS {
            return Verdict::Inconclusive(format!("{} is not approximated by fewer generators", instance.name));
        }
        counts.push(generators.len().to_string());
    }
    Verdict::Holds(format!(
        "bodies of {GENERATORS} generators, approximated by {}: along every facet normal of B it reaches as far as A, \
         exactly",
        counts.join(", ")
    ))
}
