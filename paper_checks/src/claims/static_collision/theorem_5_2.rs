//! Theorem 5.2: whether two zonotopes intersect, in O(n log^2 n).

use experiments::fit::GrowthModel;
use rand::RngExt;
use zonotope::collision::{Query, by_lad, by_slope_selection};
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth;
use crate::instances::bodies::{LocatedPoint, PLACES, bodies, bodies_in_general_position, located_point};
use crate::instances::polygons::generator;
use crate::proofs::locations::proof_of;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-5.2",
    place: Place { section: "5.1", label: "Theorem 5.2" },
    kind: ClaimKind::Theorem,
    statement: "Whether two zonotopes of R^3 with n generators in total intersect can be decided in O(n log^2 n) time",
    code: &["zonotope::collision::by_slope_selection", "zonotope::collision::by_lad"],
    figures: &[
        "certificates-of-intersection",
        "scaling-collision-operations",
        "scaling-collision-times",
        "search-of-theorem-5-2",
    ],
    check: Check::Run(check),
    tried: Tried::Growth(&["random bodies"]),
    ..Claim::LISTED
};

/// The paper's search and the default method decide as the definition does, with proofs; operations of the paper's fit
/// n log^2 n.
fn check(context: &CheckContext) -> Verdict {
    growth::verdict(context, &CLAIM, decision_evidence(context), growth_evidence, &["by_slope_selection"])
}

fn decision_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 47);
    let mut instances = bodies(&mut random, 60);
    instances.extend(bodies_in_general_position(&mut random, 21));
    let mut counts = [0; 3];
    for instance in &instances {
        let (body, zonotope) = (instance.body(), instance.in_doubles());
        for trial in 0..9 {
            let LocatedPoint { point, target, place: truth } = located_point(&mut random, &body, trial);
            let question = Query::of_point(point, &zonotope).map_err(|error| error.to_string())?;
            for answer in
                [by_slope_selection::locate(&question, context.seed, &mut ()), by_lad::locate(&question, &mut ())]
            {
                if answer.status().name() != PLACES[truth] {
                    return Err(format!("{}: {target} is {}", instance.name, answer.status()));
                }
                proof_of(&answer, &target, &body.generators)
                    .map_err(|reason| format!("{}: {target}: {reason}", instance.name))?;
            }
            counts[truth] += 1;
        }
    }
    let [inside, boundary, outside] = counts;
    Ok(format!(
        "{inside} points inside, {boundary} on the boundary and {outside} outside of {} bodies, flat and empty ones \
         among them: the paper's search and the kernel decide as the definition does, and every proof holds",
        instances.len()
    ))
}

/// The operations of the paper's search for points near the boundary of random bodies, against n log^2 n.
fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 48);
    let mut samples = Vec::new();
    for exponent in 5..=11 {
        let n = 1 << exponent;
        for _ in 0..2 {
            let rows: Vec<[f64; 3]> =
                (0..n).map(|_| std::array::from_fn(|_| random.random_range(-1.0..=1.0))).collect();
            let body = Zonotope::new([0.0; 3], rows).map_err(|error| error.to_string())?;
            let direction: [f64; 3] = std::array::from_fn(|_| random.random_range(-1.0..=1.0));
            let vertex = body.support(direction).point();
            let point = vertex.map(|c| 0.9 * c);
            let question = Query::of_point(point, &body).map_err(|error| error.to_string())?;
            let mut counts = OperationCounts::default();
            by_slope_selection::locate(&question, context.seed, &mut counts);
            samples.push(growth::sample(n, &counts));
        }
    }
    growth::evidence(
        "the paper's search on random bodies of 2^5 to 2^11 generators",
        &samples,
        GrowthModel::LinearLogSquared,
    )
}
