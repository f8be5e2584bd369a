//! Section 6, second paragraph.

use rand::RngExt;
use zonotope::motion::Motion;
use zonotope::motion::continuous::first_contact;
use zonotope::motion::space_time::Method;
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::fraction;
use crate::definitions::space::{Body, Vector};
use crate::instances::polygons::generator;
use crate::instances::sweeps::{SweepInstance, sweeps};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "disjoint-space-time-volumes",
    place: Place { section: "6", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "If the bounding space-time volumes of two bodies are disjoint over a time step, the bodies do not \
        collide in it; the converse fails",
    code: &["zonotope::motion::space_time", "zonotope::motion::continuous"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// Pairs of moving bodies with disjoint volumes are disjoint at exact times, and two bodies that follow each other have
/// volumes that meet.
fn check(context: &CheckContext) -> Verdict {
    match pairs(context) {
        Err(witness) => Verdict::Refuted(witness),
        Ok(evidence) => match a_follower() {
            Err(reason) => Verdict::Inconclusive(reason),
            Ok(false) => Verdict::Refuted("two cubes that follow each other".to_owned()),
            Ok(true) => Verdict::Holds(format!(
                "{evidence}; two cubes that follow each other at a distance of 1 have volumes that meet, and their \
                 motion is proved to be free of contact"
            )),
        },
    }
}

fn pairs(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 167);
    let (mut disjoint, mut overlapping, mut times) = (0, 0, 0);
    let moving = sweeps(&mut random, 40);
    for pair in moving.windows(2) {
        let [a, b] = [&pair[0], &pair[1]];
        let name = || format!("{} and {}", a.instance.name, b.instance.name);
        let volume = |moving: &SweepInstance| {
            let volume = moving.instance.in_doubles().swept_by(&moving.sweep, Method::ByFarthestVertex);
            volume.map_err(|error| format!("{}: {error}", name()))
        };
        if volume(a)?.intersects(&volume(b)?) {
            overlapping += 1;
            continue;
        }
        disjoint += 1;
        let bodies = [a.instance.body(), b.instance.body()];
        for _ in 0..6 {
            let [s, t] = [0, 1].map(|_| fraction(random.random_range(0..=8), 8));
            let [p, q] = [a.turning.placed(&s, &s, &bodies[0]), b.turning.placed(&t, &t, &bodies[1])];
            let center = p.center.to(&q.center);
            let difference = Body { center, generators: [p.generators, q.generators].concat() };
            if difference.holds(&Vector::at([0; 3])) {
                return Err(format!("{} meet", name()));
            }
            times += 1;
        }
    }
    Ok(format!(
        "{disjoint} pairs of moving bodies have disjoint volumes, and at {times} pairs of times, whatever the two \
         schedules, they are disjoint by the normals of their difference; {overlapping} other pairs have volumes that \
         meet"
    ))
}

/// Whether two cubes that move by 10, one behind the other, have volumes that meet and a motion without contact.
fn a_follower() -> Result<bool, String> {
    let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let cube = |x| Zonotope::new([x, 0.0, 0.0], axes.clone()).map_err(|error| error.to_string());
    let (ahead, behind) = (cube(3.0)?, cube(0.0)?);
    let motion = Motion::translation([10.0, 0.0, 0.0]).map_err(|error| error.to_string())?;
    let volumes = [&ahead, &behind].map(|body| body.swept(&motion).map_err(|error| error.to_string()));
    let [a, b] = volumes;
    Ok(a?.intersects(&b?) && first_contact([&ahead, &behind], [&motion, &motion]).name() == "separate")
}
