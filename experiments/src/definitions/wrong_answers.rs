//! Wrong answers of methods that compute in floating point alone, beside those that decide exactly.

use super::{BODY_FAMILIES, collision_methods};
use crate::definition::{Case, Experiment, Measurement, PerProfile, Tabulated, Variant, Verdict};
use crate::question::{PLACEMENTS, Question};
use crate::seed::{self, Digest};
use zonotope::tally::OperationCounts;

/// Questions of each instance.
const QUESTIONS: u32 = 10;

/// Wrong answers of methods that compute in floating point alone, beside those that decide exactly.
pub const EXPERIMENT: Experiment = Experiment {
    id: "wrong-answers",
    title: "Collision: wrong answers, method by method",
    question: "How many answers of each method are wrong or missing? The truth of each question is known from its \
               construction. GJK is our own, and computes in floating point alone; the linear programs' engines are \
               only believed where an exact proof succeeds, so they fail openly instead of being wrong. Instance k \
               asks about placement k: overlapping, separated, gaps of 1e-3, 1e-6, 1e-9 and 1e-12 inside and \
               outside, touching.",
    claims: &["theorem-5.2", "difference-of-centers"],
    families: BODY_FAMILIES,
    sizes: PerProfile { quick: &[6, 32], full: &[6, 16, 32, 64, 256, 1 << 10] },
    instances: PerProfile::both(PLACEMENTS.len() as u32),
    variants: &[
        Variant::at_all_sizes("by_lad", "Kernel"),
        Variant { id: "by_slope_selection", title: "Theorem 5.2", largest: PerProfile::both(256) },
        Variant { id: "by_explicit_faces", title: "Explicit faces", largest: PerProfile::both(64) },
        Variant::at_all_sizes("by_gjk", "Our GJK in floating point"),
        Variant { id: "clarabel", title: "Linear program, proof from clarabel's guess", largest: PerProfile::both(64) },
        Variant { id: "microlp", title: "Linear program, proof from microlp's guess", largest: PerProfile::both(64) },
    ],
    measure,
    table: Tabulated::Total,
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let family = case.body_family()?;
    let placement = collision_methods::placement(case.instance);
    let mut counts = OperationCounts::default();
    let [mut asked, mut wrong, mut failed] = [0_u32; 3];
    let mut digest = Digest::default();
    for number in 0..QUESTIONS {
        let seed = seed::seed_of(case.instance_seed, &number.to_string());
        let Some(question) = Question::about(family.generate(case.n, seed), placement, seed) else { continue };
        asked += 1;
        let member = collision_methods::guess(case.variant, &question.displacement(), case.seed, &mut counts)?;
        match member {
            Some(member) => wrong += u32::from(member != question.is_member()),
            None => failed += 1,
        }
        digest = digest.word(member.map_or(2, u64::from));
    }
    // Wrong answers are what is measured here; only an exact method may not have any.
    let verdict = if wrong > 0 && collision_methods::is_exact(case.variant) {
        Verdict::Wrong(format!("{wrong} of {asked} answers contradict the questions' construction"))
    } else if wrong + failed > 0 {
        Verdict::Unchecked(format!("{wrong} wrong and {failed} missing of {asked} answers, which is what is counted"))
    } else {
        Verdict::Correct("wrong answers counted against the questions' construction".to_owned())
    };
    Ok(Measurement::new(&counts, digest.finish(), verdict)
        .with_value("asked", f64::from(asked))
        .with_value("wrong", f64::from(wrong))
        .with_value("failed", f64::from(failed)))
}
