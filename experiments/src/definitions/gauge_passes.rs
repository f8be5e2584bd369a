//! How often the exact gauge reads its input.

use super::{BODY_FAMILIES, collision_methods};
use crate::definition::{Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Tabulated, Variant};
use crate::fit::GrowthModel;
use zonotope::tally::{Operation, OperationCounts};

/// How often the exact gauge reads its input.
pub const EXPERIMENT: Experiment = Experiment {
    id: "gauge-passes",
    title: "Exact gauge: passes over the generators",
    question: "How often does the exact gauge read its input? `passes` are the generators read, and the lines \
               evaluated once few generators are left, divided by the number of generators. They count readings, not \
               time: the table of peers has times in passes.",
    claims: &["theorem-5.2"],
    families: BODY_FAMILIES,
    real_inputs: &[],
    sizes: PerProfile {
        quick: &[1 << 10, 1 << 12, 1 << 14],
        full: &[1 << 10, 1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20],
    },
    instances: PerProfile { quick: 3, full: 4 },
    variants: &[Variant { id: "by_lad", title: "Kernel: exact gauge", largest: PerProfile::both(usize::MAX) }],
    measure,
    table: Tabulated::MedianAtLargest,
    timing: None,
    fits: &[FitPlan {
        quantity: Quantity::Value("passes"),
        variant: "by_lad",
        families: BODY_FAMILIES,
        models: GrowthModel::ALL,
        bound: Some(GrowthModel::Constant),
    }],
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let question = collision_methods::question(case, collision_methods::ALL_PLACEMENTS)?;
    let mut counts = OperationCounts::default();
    let reply = collision_methods::ask(case.variant, &question.displacement(), case.seed, &mut counts)?;
    let reads = [Operation::GeneratorRead, Operation::LineEvaluation, Operation::PartEvaluation];
    let read: u64 = reads.map(|read| counts.get(read)).iter().sum();
    let passes = read as f64 / case.n as f64;
    Ok(Measurement::new(&counts, reply.digest(), reply.verdict(&question)).with_value("passes", passes))
}
