//! The number of times that pruning reads its input.

use super::{PRUNING_SIZES, lad_scaling};
use crate::definition::{Bound, Experiment, FitPlan, PerProfile, Quantity, Variant};
use crate::fit::GrowthModel;

const FAMILIES: &[&str] = &["random_lines", "lattice_lines", "concurrent_lines", "symmetric_lines", "ellipse_thin"];

/// The number of times that pruning reads its input.
pub const EXPERIMENT: Experiment = Experiment {
    id: "pruning-passes",
    title: "Pruning: passes over the lines",
    question: "How often does pruning read its input? `passes` are evaluations of the lines of the input over their \
               number. What is done on samples and on what cells leave over comes on top: operations on parts, in \
               the experiment on growth.",
    claims: &["theorem-4.5"],
    families: FAMILIES,
    sizes: PRUNING_SIZES,
    instances: PerProfile { quick: 3, full: 5 },
    variants: &[Variant::at_all_sizes("by_pruning", "Pruning")],
    measure: lad_scaling::measure,
    fits: &[FitPlan::new(Quantity::Value("passes"), "by_pruning", FAMILIES, GrowthModel::ALL)
        .within(Bound::own(GrowthModel::Constant))
        .at_least(GrowthModel::Constant)],
    ..Experiment::COUNTED
};
