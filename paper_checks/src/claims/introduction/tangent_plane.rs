//! Section 1: the plane that touches a zonotope along a normal.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::Vector;
use crate::instances::bodies::{bodies, doubles, random_member, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "tangent-plane",
    place: Place { section: "1", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "For any unit vector there is a unique hyperplane normal to it and tangent to the zonotope at some face",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies of R^3"]),
    ..Claim::LISTED
};

/// The plane at the support value has the body on one side and a point of it, the one that the library names, within;
/// a plane farther in has points beyond it, and one farther out has none.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 101);
    let instances = bodies(&mut random, 40);
    let (mut planes, mut members) = (0, 0);
    for instance in &instances {
        let (body, zonotope) = (instance.body(), instance.in_doubles());
        for _ in 0..6 {
            let direction = random_vector(&mut random, 9);
            if direction == [0; 3] {
                continue;
            }
            let normal = Vector::at(direction);
            let height = body.support(&normal);
            let touching = Vector::exactly(zonotope.support(doubles(direction)).point());
            if normal.dot(&touching) != height || !body.holds(&touching) {
                return Verdict::Refuted(format!("{}: no face along {normal}", instance.name));
            }
            let beyond = touching.plus(&fraction(1, 1000), &normal);
            if body.holds(&beyond) {
                return Verdict::Refuted(format!("{}: {beyond} is in the body", instance.name));
            }
            for _ in 0..5 {
                let member = random_member(&mut random, &body);
                if height.clone() - normal.dot(&member) < integer(0) {
                    return Verdict::Refuted(format!("{}: {member} is beyond the plane", instance.name));
                }
                members += 1;
            }
            planes += 1;
        }
    }
    Verdict::Holds(format!(
        "{planes} planes at the support value of {} bodies, flat and empty ones among them: each meets the body, \
         {members} points of the bodies are not beyond it, and the body ends there",
        instances.len()
    ))
}
