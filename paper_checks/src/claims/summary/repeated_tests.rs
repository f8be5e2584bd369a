//! Section 2, fifth bullet.

use rand::RngExt;
use zonotope::Pose;
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::collision::tracking::{WalkingTracker, WarmTracker};
use zonotope::zonotope::{PreparedBody, Zonotope};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::Vector;
use crate::instances::bodies::{doubles, random_vector};
use crate::instances::polygons::generator;
use crate::proofs::locations::{Proof, proof_of};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "summary-repeated-tests",
    place: Place { section: "2", label: "fifth bullet" },
    kind: ClaimKind::Statement,
    statement: "Bounding volume hierarchies and closest-feature tracking can be run for repeated tests on the \
        generator lists alone",
    code: &["zonotope::collision::hierarchy", "zonotope::collision::tracking"],
    figures: &["nested-hierarchy", "coherence"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies of one size"]),
    ..Claim::LISTED
};

/// Generators of each body: enough for a hierarchy to have levels.
const GENERATORS: usize = 80;

/// Frames of each motion.
const FRAMES: i64 = 40;

/// Bodies pass through each other; the descent through nested levels and two trackers say the same of each frame, with
/// proofs about the bodies themselves.
fn check(context: &CheckContext) -> Verdict {
    match evidence(context) {
        Ok(evidence) => Verdict::Holds(evidence),
        Err(witness) => Verdict::Refuted(witness),
    }
}

fn evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 92);
    let mut counts = [0; 2];
    let mut levels = [0; 2];
    for reach in [3, 40, 1000] {
        let mut body = || -> Result<Zonotope<3>, String> {
            let rows = (0..GENERATORS).map(|_| doubles(random_vector(&mut random, reach))).collect();
            Zonotope::new([0.0; 3], rows).map_err(|error| error.to_string())
        };
        let [fixed, moving] = [body()?, body()?];
        let [first, second] = [&fixed, &moving].map(|body| Hierarchy::new(body.clone()));
        let [a, b] = [&fixed, &moving].map(|body| PreparedBody::new(body.clone()));
        let mut warm = WarmTracker::new(&a, &b);
        let mut walking = WalkingTracker::new(&fixed, &moving).map_err(|error| error.to_string())?;
        let generators: Vec<Vector> =
            [&fixed, &moving].iter().flat_map(|body| body.generators()).map(|row| Vector::exactly(*row)).collect();
        let heading = random_vector(&mut random, 9);
        let beside = random.random_range(-3..=3);
        for frame in -FRAMES..=FRAMES {
            let step = reach * GENERATORS as i64 / 20;
            let place = [0, 1, 2].map(|k| frame * step * heading[k] / 6 + beside);
            let pose = Pose::from_translation(doubles(place)).map_err(|error| error.to_string())?;
            let descent = first.at(&Pose::IDENTITY).intersection(&second.at(&pose), &mut ());
            let tracked = warm.frame(&Pose::IDENTITY, &pose, &mut ());
            let walked = walking.frame([0.0; 3], doubles(place)).map_err(|error| error.to_string())?;
            if descent.status() != tracked.status() || descent.status() != walked.status() {
                return Err(format!("coordinates to {reach}: {place:?}"));
            }
            let target = Vector::at(place);
            for location in [descent.location(), tracked.location(), walked.location()] {
                let proof = proof_of(&location, &target, &generators)
                    .map_err(|reason| format!("coordinates to {reach}: {place:?}: {reason}"))?;
                counts[usize::from(matches!(proof, Proof::Separated(_)))] += 1;
            }
            levels[0] += descent.visited();
            levels[1] += 1;
        }
    }
    let [members, separated] = counts;
    let [visited, frames] = levels;
    Ok(format!(
        "{frames} frames of bodies of {GENERATORS} generators that pass through each other: a descent through nested \
         levels, {visited} pairs of levels in all, a walk to the closest feature and the kernel that begins with the \
         last frame agree, and {members} proofs of a common point and {separated} of a separating direction hold"
    ))
}
