//! Collisions that methods of motion planning miss.

use crate::definition::{Case, Experiment, Measurement, PerProfile, Tabulated, Variant, Verdict};
use crate::moving::MovingBodies;
use crate::moving::samples::Samples;
use crate::moving::soundness::RESOLUTION;
use crate::seed::{self, Digest};
use rivals::first_contact::by_hull_of_end_poses::first_meeting_stretch;
use rivals::first_contact::by_sampling::first_sampled_contact;
use zonotope::motion::continuous::{FirstContact, Method};
use zonotope::tally::OperationCounts;

/// Motions of each instance.
const MOTIONS: u32 = 40;

/// Collisions that methods of motion planning miss.
pub const EXPERIMENT: Experiment = Experiment {
    id: "motion-misses",
    title: "Motion: collisions that are missed",
    question: "How many collisions does a method miss that looks at n equal steps of a motion? Sampling asks at each \
               step, and the hulls of end poses are those of both bodies at the ends of a step. Control points are \
               held to samples with a bound of the bodies' way between them, and n does not matter to them. Each \
               collision is proved by coefficients of the generators at a time.",
    claims: &["collisions-between-steps"],
    families: &["fast_boxes", "crafted_motions"],
    sizes: PerProfile::both(&[8, 32, 128]),
    instances: PerProfile { quick: 4, full: 25 },
    variants: &[
        Variant::at_all_sizes("by_control_points", "Control points"),
        Variant::at_all_sizes("by_sampling", "Sampling"),
        Variant::at_all_sizes("by_hull_of_end_poses", "Hull of end poses"),
    ],
    measure,
    table: Tabulated::Total,
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let family = case.motion_family()?;
    let steps = u32::try_from(case.n).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    let [mut collisions, mut missed] = [0_u32; 2];
    let mut digest = Digest::default();
    for number in 0..MOTIONS {
        let seed = seed::seed_of(case.instance_seed, &number.to_string());
        let moving = MovingBodies::of(&family.generate(seed))?;
        let (bodies, motions) = (moving.bodies.each_ref(), moving.motions.each_ref());
        let found = Method::default().first_contact(bodies, motions, RESOLUTION, &mut counts);
        let is_collision = matches!(found, FirstContact::Contact { .. });
        let is_missed = match case.variant {
            "by_control_points" => moving.samples_against(&found) == Samples::Contradict,
            "by_sampling" => is_collision && first_sampled_contact(bodies, motions, steps).is_none(),
            "by_hull_of_end_poses" => is_collision && first_meeting_stretch(bodies, motions, steps).is_none(),
            other => return Err(format!("no method is called {other}")),
        };
        collisions += u32::from(is_collision);
        missed += u32::from(is_missed);
        digest = digest.word(u64::from(is_collision)).word(u64::from(is_missed));
    }
    // Collisions that are missed are what is measured here; only a method with proofs may not miss any.
    let verdict = if missed > 0 && case.variant == "by_control_points" {
        Verdict::Wrong(format!("samples contradict {missed} answers"))
    } else {
        Verdict::Correct("collisions proved by coefficients".to_owned())
    };
    Ok(Measurement::new(&counts, digest.finish(), verdict)
        .with_value("collisions", f64::from(collisions))
        .with_value("missed", f64::from(missed)))
}
