//! The number of times that the exact gauge reads its input.

use super::{BODY_FAMILIES, PRUNED_BODY_SIZES, collision_methods};
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant};
use crate::fit::GrowthModel;
use zonotope::tally::OperationCounts;

/// The number of times that the exact gauge reads its input.
pub const EXPERIMENT: Experiment = Experiment {
    id: "gauge-passes",
    title: "Exact gauge: passes over the generators",
    question: "How often does the exact gauge read its input? `passes` are the generators read, and the lines \
               evaluated once few generators are left, divided by the number of generators, where it prunes. Smaller \
               bodies are evaluated at once, each generator again and again, so that a law across both would be that \
               of the change. They count readings, not time: the table of peers has times in passes.",
    claims: &["theorem-5.2"],
    families: BODY_FAMILIES,
    sizes: PRUNED_BODY_SIZES,
    instances: PerProfile { quick: 33, full: 8 },
    variants: &[Variant::at_all_sizes("by_lad", "Kernel: exact gauge")],
    measure,
    fits: &[FitPlan::new(Quantity::Value("passes"), "by_lad", BODY_FAMILIES, GrowthModel::ALL)
        .within(Bound::own(GrowthModel::Constant))
        .at_least(GrowthModel::Constant)],
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let question = collision_methods::question(case, collision_methods::ALL_PLACEMENTS)?;
    let mut counts = OperationCounts::default();
    let reply = collision_methods::ask(case.variant, &question.displacement(), case.seed, &mut counts)?;
    let passes = collision_methods::passes(&counts, case.n);
    Ok(Measurement::new(&counts, reply.digest(), reply.verdict(&question)).with_value("passes", passes))
}
