//! Lemma 5.1: from two bodies to a body and a point.

use zonotope::collision::{Query, by_lad};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{BodyInstance, bodies, random_member};
use crate::instances::polygons::generator;
use crate::proofs::locations::{Proof, proof_of};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.1",
    place: Place { section: "5.1", label: "Lemma 5.1" },
    kind: ClaimKind::Lemma,
    statement: "Two zonotopes intersect iff the difference of their centres lies in the centred zonotope of all their \
        generators",
    code: &["zonotope::collision", "zonotope::collision::by_lad"],
    figures: &["certificates-of-intersection"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// From the library's proof about q − p, makes a proof about the two bodies: a point in both, or a direction that
/// separates them.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 39);
    let instances = bodies(&mut random, 60);
    let (mut meeting, mut touching, mut apart) = (0, 0, 0);
    for (index, first) in instances.iter().enumerate() {
        for step in [1, 5, 11] {
            let mut second = instances[(index + step) % instances.len()].clone();
            if index % 2 == 0 {
                place_on(&mut second, first, &mut random);
            }
            let (a, b) = (first.body(), second.body());
            let zonotopes = [first.in_doubles(), second.in_doubles()];
            let answer = by_lad::locate(&Query::between(&zonotopes[0], &zonotopes[1]), &mut ());
            let all: Vec<Vector> = a.generators.iter().chain(&b.generators).cloned().collect();
            let target = a.center.to(&b.center);
            let sum = Body { center: Vector::at([0; 3]), generators: all };
            let names = format!("{} and {}", first.name, second.name);
            if answer.is_member() != sum.holds(&target) {
                return Verdict::Inconclusive(format!("{names}: the library says {}", answer.status()));
            }
            let agrees = match proof_of(&answer, &target, &sum.generators) {
                Err(reason) => return Verdict::Inconclusive(format!("{names}: {reason}")),
                Ok(Proof::Member(coefficients)) => {
                    let terms = coefficients.iter().zip(&sum.generators).take(a.generators.len());
                    let common = terms.fold(a.center.clone(), |point, (c, generator)| point.plus(c, generator));
                    if answer.status().name() == "inside" {
                        meeting += 1
                    } else {
                        touching += 1
                    }
                    a.holds(&common) && b.holds(&common)
                }
                Ok(Proof::Separated(direction)) => {
                    apart += 1;
                    let backwards = direction.to(&Vector::at([0; 3]));
                    a.support(&direction) < -b.support(&backwards)
                }
            };
            if !agrees {
                return Verdict::Refuted(names);
            }
        }
    }
    Verdict::Holds(format!(
        "{} pairs of bodies, flat and empty ones among them: where q - p lies in the zonotope of all generators \
         ({meeting} inside, {touching} on the boundary) the coefficients give a point of both bodies, where it does \
         not ({apart}) the direction separates them",
        meeting + touching + apart
    ))
}

/// Moves the second body so that a lattice point near some member of the first is its centre.
fn place_on(second: &mut BodyInstance, first: &BodyInstance, random: &mut rand_pcg::Pcg64Mcg) {
    let member = random_member(random, &first.body());
    second.center = member.0.each_ref().map(|c| c.to_f64_fast() as i64);
}
