//! Central symmetry of a zonotope and of its boundary.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::space::Vector;
use crate::instances::bodies::bodies;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "central-symmetry",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Every zonotope is centrally symmetric, and every facet has an opposite congruent one",
    code: &["zonotope::zonotope::faces"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
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
    Verdict::Holds(format!(
        "each of the {facets} facets of {solid} bodies of full dimension, reflected through the centre, is the facet \
         with the opposite normal"
    ))
}
