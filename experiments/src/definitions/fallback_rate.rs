//! The rate at which floating point cannot decide and exact arithmetic must.

use super::{BODY_FAMILIES, collision_methods};
use crate::definition::{Case, Experiment, Measurement, PerProfile, Variant, Verdict};
use crate::question::Question;
use crate::seed::{self, Digest};
use zonotope::tally::{Operation, OperationCounts};

/// Questions of each instance.
const QUESTIONS: u32 = 25;

/// The placements nearer to contact than a relative 1e-9.
const NEAREST: [&str; 3] = ["inside_1e-12", "outside_1e-12", "touching"];

/// The rate at which floating point cannot decide and exact arithmetic must.
pub const EXPERIMENT: Experiment = Experiment {
    id: "fallback-rate",
    title: "Collision: how often exact arithmetic is needed",
    question: "Of how many questions does floating point leave a sign undecided, so that exact arithmetic has to \
               decide it? Values: questions asked, those with such a sign (`fallbacks`), both for gaps of 1e-9 and \
               more alone (`asked_apart`, `fallbacks_apart`), and the exact signs a question (`signs`).",
    claims: &["theorem-5.2"],
    families: BODY_FAMILIES,
    sizes: PerProfile { quick: &[16, 256], full: &[16, 64, 256, 1 << 10, 1 << 12] },
    instances: PerProfile { quick: 2, full: 4 },
    variants: &[
        Variant::at_all_sizes("by_lad", "Kernel: exact gauge"),
        Variant::at_all_sizes("by_lad_location", "Kernel: location"),
    ],
    measure,
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let generators = case.body()?;
    let mut total = OperationCounts::default();
    let [mut asked, mut fallbacks, mut asked_apart, mut fallbacks_apart] = [0_u32; 4];
    let (mut digest, mut verdict) = (Digest::default(), Verdict::Correct(collision_methods::PROVED.to_owned()));
    for number in 0..QUESTIONS {
        let seed = seed::seed_of(case.instance_seed, &number.to_string());
        let placement = collision_methods::placement(number);
        let Some(question) = Question::about(generators.clone(), placement, seed) else { continue };
        let mut counts = OperationCounts::default();
        let reply = collision_methods::ask(case.variant, &question.displacement(), case.seed, &mut counts)?;
        match reply.verdict(&question) {
            Verdict::Correct(_) => {}
            unproved => verdict = unproved,
        }
        let fell_back = u32::from(counts.get(Operation::ExactFallback) > 0);
        asked += 1;
        fallbacks += fell_back;
        if !NEAREST.contains(&placement.id) {
            asked_apart += 1;
            fallbacks_apart += fell_back;
        }
        digest = digest.word(reply.digest());
        total.merge(&counts);
    }
    if asked == 0 {
        verdict = Verdict::Unchecked("no question can be asked about this body".to_owned());
    }
    let signs = total.get(Operation::ExactFallback) as f64 / f64::from(asked.max(1));
    Ok(Measurement::new(&total, digest.finish(), verdict)
        .with_value("asked", f64::from(asked))
        .with_value("fallbacks", f64::from(fallbacks))
        .with_value("asked_apart", f64::from(asked_apart))
        .with_value("fallbacks_apart", f64::from(fallbacks_apart))
        .with_value("signs", signs))
}
