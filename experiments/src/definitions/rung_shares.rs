//! Which method answers: the share of each rung of the kernel's ladder, by family and size.

use super::{BODY_FAMILIES, collision_methods};
use crate::definition::{Case, Experiment, Measurement, PerProfile, Tabulated, Variant, Verdict};
use crate::question::Question;
use crate::seed::{self, Digest};
use zonotope::tally::{OperationCounts, Rung};

/// Questions of each instance: four at each placement.
const QUESTIONS: u32 = 44;

/// Which method answers: the share of each rung of the kernel's ladder.
pub const EXPERIMENT: Experiment = Experiment {
    id: "rung-shares",
    title: "Collision: which rung of the ladder answers",
    question: "Which rung of the ladder answers? Several methods can answer a question of collision; they are tried \
               from the cheapest to the one that answers all. For each family and size the values are the answers of \
               each rung over questions at several distances from the boundary. A location may be told early, and \
               then has no optimum; each location of generators in space has one proof. A rung of doubles earns its \
               place by answers; those of an exact rung are what the family pays for.",
    claims: &[],
    families: BODY_FAMILIES,
    sizes: PerProfile { quick: &[6, 64, 1 << 10], full: &[6, 64, 1 << 10, 1 << 12, 1 << 14] },
    instances: PerProfile { quick: 1, full: 2 },
    variants: &[
        Variant::at_all_sizes("by_lad", "Kernel: exact gauge"),
        Variant::at_all_sizes("by_lad_location", "Kernel: location"),
    ],
    measure,
    table: Tabulated::Total,
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let generators = case.body()?;
    let mut total = OperationCounts::default();
    let mut asked = 0_u32;
    let (mut digest, mut verdict) = (Digest::default(), Verdict::Unchecked("no question was asked".to_owned()));
    for number in 0..QUESTIONS {
        let seed = seed::seed_of(case.instance_seed, &number.to_string());
        let placement = collision_methods::placement(number);
        let Some(question) = Question::about(generators.clone(), placement, seed) else { continue };
        let reply = collision_methods::ask(case.variant, &question.displacement(), case.seed, &mut total)?;
        if !matches!(verdict, Verdict::Wrong(_)) {
            verdict = reply.verdict(&question);
        }
        asked += 1;
        digest = digest.word(reply.digest());
    }
    let measurement = Measurement::new(&total, digest.finish(), verdict).with_value("asked", f64::from(asked));
    let answers = |rung| total.answers_of(rung);
    let reached = Rung::ALL.into_iter().filter(|rung| answers(*rung) > 0);
    Ok(reached.fold(measurement, |measurement, rung| measurement.with_value(rung.name(), answers(rung) as f64)))
}
