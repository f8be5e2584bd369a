//! Operations and time of each kernel method against the number of lines.

use super::kernel_methods::{self, KernelInput};
use crate::definition::{
    Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use zonotope::interop::verifier::check_lad;
use zonotope::tally::{Operation, OperationCounts};

/// Random lines, and the lines of 4.1 for points that are (nearly) all on their hull.
const FAMILIES: &[&str] = &["random_lines", "circle", "ellipse", "random_convex", "regular_polygon"];

/// Operations and time of each kernel method against the number of lines.
pub const EXPERIMENT: Experiment = Experiment {
    id: "lad-scaling",
    title: "Least absolute deviations kernel: growth with the number of lines",
    question: "How do operations and time of each method grow with the number of lines, on random lines and on those \
               of polygons, where all may meet in one point? `passes` are evaluations of the lines of the input over \
               their number; `operations_on_parts` are those on samples and on what is left of the lines, which come \
               on top.",
    claims: &["theorem-4.5", "halving-search"],
    families: FAMILIES,
    sizes: super::PRUNING_SIZES,
    instances: PerProfile { quick: 6, full: 5 },
    variants: &[
        Variant {
            id: "by_slope_selection",
            title: "Slope selection (the paper's search)",
            largest: PerProfile { quick: 1 << 14, full: 1 << 16 },
        },
        Variant {
            id: "by_line_search",
            title: "Line searches",
            largest: PerProfile { quick: 1 << 17, full: usize::MAX },
        },
        Variant::at_all_sizes("by_pruning", "Pruning"),
    ],
    measure,
    timing: Some(Timing { sizes: super::KERNEL_SIZES, repetitions: PerProfile::both(3), prepare }),
    fits: &[
        FitPlan::of_operations("by_slope_selection", FAMILIES)
            .within(Bound::of_paper(GrowthModel::LinearLogSquared, "Theorem 4.5"))
            .at_least(GrowthModel::Linear),
        FitPlan::of_operations("by_line_search", FAMILIES),
        OF_PRUNING.at_least(GrowthModel::Linear),
        OF_PRUNING.of(Quantity::Count("line_evaluation")).at_least(GrowthModel::Linear),
        OF_PRUNING.of(Quantity::Value("operations_on_parts")),
    ],
    ..Experiment::COUNTED
};

const OF_PRUNING: FitPlan = FitPlan::of_operations("by_pruning", FAMILIES).within(Bound::own(GrowthModel::Linear));

/// Shared with the experiments on passes and on the race.
pub(super) fn measure(case: &Case) -> Result<Measurement, String> {
    let method = kernel_methods::method(case)?;
    KernelInput::of(case)?.with_problem(|problem| {
        let mut counts = OperationCounts::default();
        let outcome = method.minimize(problem, case.seed, &mut counts);
        let verdict = Verdict::of_verifier("check_lad", check_lad(problem, &outcome));
        let passes = counts.get(Operation::LineEvaluation) as f64 / problem.len() as f64;
        let on_parts = counts.get(Operation::PartEvaluation) + counts.get(Operation::Comparison);
        Ok(Measurement::new(&counts, kernel_methods::digest(problem, &outcome), verdict)
            .with_value("lines", problem.len() as f64)
            .with_value("passes", passes)
            .with_value("operations_on_parts", on_parts as f64))
    })
}

pub(super) fn prepare(case: &Case) -> Result<TimedWork, String> {
    let (method, seed) = (kernel_methods::method(case)?, case.seed);
    let input = KernelInput::of(case)?;
    Ok(Box::new(move |stopwatch| {
        input.with_problem(|problem| {
            let outcome = stopwatch.lap("total", || method.minimize(problem, seed, &mut ()));
            Ok(kernel_methods::digest(problem, &outcome))
        })
    }))
}
