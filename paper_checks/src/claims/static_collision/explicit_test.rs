//! Section 5.1: the test by way of the explicit polytope.

use families::bodies;
use zonotope::collision::{Query, by_explicit_faces};
use zonotope::tally::{Operation, OperationCounts};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::bodies::bodies_in_general_position;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "explicit-test",
    place: Place { section: "5.1", label: "after Lemma 5.1" },
    kind: ClaimKind::Statement,
    statement: "A test for inclusion that computes the explicit zonotope takes at least of order n^2 time, as the \
        number of vertices can be quadratic in the number of generators",
    code: &["zonotope::collision::by_explicit_faces"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Bodies with as many vertices as that, which any such test writes down, and the operations of the library's on some:
/// one at least for each pair of opposite facets, which it looks at together.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 105);
    let instances = bodies_in_general_position(&mut random, 21);
    for instance in &instances {
        let (n, vertices) = (instance.generators.len(), instance.body().vertices().len());
        if vertices != n * (n - 1) + 2 {
            return Verdict::Refuted(format!("{}: {vertices} vertices", instance.name));
        }
    }
    match [16, 32, 64, 128].into_iter().map(|n| operations(n, context.seed)).collect::<Result<Vec<_>, _>>() {
        Ok(found) => Verdict::Holds(format!(
            "{} bodies in general position have n(n-1) + 2 vertices, and each of them has to be written; operations of \
             the library's explicit test: {}",
            instances.len(),
            found.join(", ")
        )),
        Err(reason) => Verdict::Refuted(reason),
    }
}

/// The operations of a test on a random body beside the pairs of its facets; an error if they are fewer.
fn operations(n: usize, seed: u64) -> Result<String, String> {
    let family = bodies::find("random_bodies").ok_or("there is no family of random bodies")?;
    let body = Zonotope::new([0.0; 3], family.generate(n, seed)).map_err(|error| error.to_string())?;
    let point = body.support([1.0, 2.0, 3.0]).point().map(|c| 0.9 * c);
    let question = Query::of_point(point, &body).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    by_explicit_faces::locate(&question, &mut counts).map_err(|error| error.to_string())?;
    let total: u64 = Operation::ALL.iter().map(|&operation| counts.get(operation)).sum();
    let pairs = (n * (n - 1) / 2) as u64;
    let sentence = format!("{total} for {pairs} pairs of facets of n = {n}");
    if total >= pairs { Ok(sentence) } else { Err(sentence) }
}
