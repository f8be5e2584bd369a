//! How often pruning reads its input.

use super::{KERNEL_SIZES, kernel_methods};
use crate::definition::{Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use zonotope::lad::verify;
use zonotope::tally::{Operation, OperationCounts};

const FAMILIES: &[&str] = &["random_lines", "lattice_lines", "concurrent_lines", "symmetric_lines"];

/// How often pruning reads its input.
pub const EXPERIMENT: Experiment = Experiment {
    id: "pruning-passes",
    title: "Pruning: passes over the lines",
    question: "The number of passes (evaluations of lines divided by their number) does not grow with the number of lines; it \
               falls towards one, or two when the first cell misses the optimum. Concurrent lines tell a sample little \
               and cost a few passes more.",
    claims: &["theorem-4.5"],
    families: FAMILIES,
    real_inputs: &[],
    sizes: KERNEL_SIZES,
    instances: PerProfile::both(5),
    variants: &[Variant { id: "by_pruning", title: "Pruning", largest: PerProfile::both(usize::MAX) }],
    measure,
    timing: None,
    fits: &[FitPlan {
        quantity: Quantity::Value("passes"),
        variant: "by_pruning",
        families: FAMILIES,
        smallest: 0,
        models: GrowthModel::ALL,
        bound: Some(GrowthModel::Constant),
    }],
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let problem = kernel_methods::problem(case)?;
    let mut counts = OperationCounts::default();
    let outcome = kernel_methods::minimize(case, &problem, &mut counts)?;
    let verdict = Verdict::of_check("lad::verify", verify::verify(&problem, &outcome));
    let passes = counts.get(Operation::LineEvaluation) as f64 / problem.len() as f64;
    Ok(Measurement::new(&counts, kernel_methods::digest(&problem, &outcome), verdict).with_value("passes", passes))
}
