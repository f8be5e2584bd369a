//! Generators that are not independent.

use zonotope::collision::{Query, by_lad};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::fraction;
use crate::definitions::space::Vector;
use crate::instances::bodies::{are_independent, bodies, random_member, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "independent-generators",
    place: Place { section: "3", label: "first paragraph" },
    kind: ClaimKind::Note,
    statement: "For simplicity any d generators are assumed to be linearly independent",
    remedy: Some(
        "the assumption is stated, and a program meets bodies without it: merge parallel generators, drop zero ones, \
            gather coplanar ones into one facet, and accept flat and empty zonotopes: the difference of two boxes has \
            parallel generators, the truncated octahedron has coplanar triples, and 4.2 gives zero coefficients",
    ),
    code: &["zonotope::zonotope", "zonotope::collision::by_lad"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Shows dependent generators in the paper's own examples, and that the library answers there as the definition does.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 41);
    let (mut dependent, mut points) = (0, 0);
    let mut examples = Vec::new();
    for instance in bodies(&mut random, 40) {
        if are_independent(&instance.generators) && instance.generators.len() >= 3 {
            continue;
        }
        dependent += 1;
        if ["the difference of two boxes", "the truncated octahedron"].contains(&instance.name.as_str()) {
            examples.push(instance.name.clone());
        }
        let (body, zonotope) = (instance.body(), instance.in_doubles());
        for trial in 0..12 {
            let member = random_member(&mut random, &body);
            let shift = if trial % 2 == 0 { fraction(0, 1) } else { fraction(1, 4) };
            let point = member.plus(&shift, &Vector::at(random_vector(&mut random, 2)));
            let rounded = point.0.each_ref().map(|c| c.to_f64_fast());
            let exact = Vector::exactly(rounded);
            let question = Query::of_point(rounded, &zonotope).expect("the point is finite");
            let status = match (body.holds_inside(&exact), body.holds(&exact)) {
                (true, _) => "inside",
                (false, true) => "boundary",
                (false, false) => "outside",
            };
            let answer = by_lad::locate(&question, &mut ());
            if answer.status().name() != status {
                return Verdict::Inconclusive(format!(
                    "{}: {exact} is {status}, not {}",
                    instance.name,
                    answer.status()
                ));
            }
            points += 1;
        }
    }
    if examples.len() != 2 {
        return Verdict::Inconclusive(format!("only {examples:?} have dependent triples"));
    }
    Verdict::Holds(format!(
        "{} have dependent triples; on {dependent} bodies with dependent generators, flat and empty ones among them, \
         {points} points are located as by the definition",
        examples.join(" and ")
    ))
}
