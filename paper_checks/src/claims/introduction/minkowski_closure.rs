//! Sums and differences of zonotopes are zonotopes.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{bodies, random_member, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "minkowski-closure",
    place: Place { section: "1", label: "first bullet" },
    kind: ClaimKind::Statement,
    statement: "Zonotopes are closed under Minkowski sum and difference, so intersection reduces to membership of a \
        point",
    remedy: Some(
        "the difference is A + (-B), all a - b; the erosion of A by B is another body, and no zonotope in general",
    ),
    code: &["zonotope::zonotope", "zonotope::collision"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies of R^3"]),
    ..Claim::LISTED
};

/// The support function of a sum is the sum of the support functions, and sums and differences of points lie in the
/// bodies of the joined generators.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 32);
    let instances = bodies(&mut random, 40);
    let (mut pairs, mut points) = (0, 0);
    for (index, first) in instances.iter().enumerate() {
        let second = &instances[(7 * index + 3) % instances.len()];
        let (a, b) = (first.body(), second.body());
        let [sum, difference] = [1, -1].map(|sign| joined(&a, &b, sign));
        for _ in 0..10 {
            let direction = Vector::at(random_vector(&mut random, 9));
            let opposite = direction.to(&Vector::at([0; 3]));
            if sum.support(&direction) != a.support(&direction) + b.support(&direction)
                || difference.support(&direction) != a.support(&direction) + b.support(&opposite)
            {
                return Verdict::Refuted(format!("{} and {}: direction {direction}", first.name, second.name));
            }
        }
        if a.generators.len() + b.generators.len() <= 10 {
            for _ in 0..5 {
                let (p, q) = (random_member(&mut random, &a), random_member(&mut random, &b));
                let [plus, minus] = [1, -1].map(|sign| p.plus(&integer(sign), &q));
                if !sum.holds(&plus) || !difference.holds(&minus) {
                    return Verdict::Refuted(format!("{} and {}: points {p} and {q}", first.name, second.name));
                }
                points += 1;
            }
        }
        pairs += 1;
    }
    Verdict::Holds(format!(
        "{pairs} pairs of bodies: A + B and A + (-B) have the generators of both, for their support functions are the \
         sums of those of A and of B or -B in 10 directions each, and {points} sums and differences of points lie in \
         them; the reduction is Lemma 5.1"
    ))
}

fn joined(a: &Body, b: &Body, sign: i64) -> Body {
    let generators = a.generators.iter().chain(&b.generators).cloned().collect();
    Body { center: a.center.plus(&integer(sign), &b.center), generators }
}
