//! The kernel's methods against each other by time, on the same lines in one run.

use super::lad_scaling;
use crate::definition::{Experiment, PerProfile, Tabulated, Timing, Variant};

const SIZES: PerProfile<&[usize]> = PerProfile { quick: &[1 << 12, 1 << 15], full: &[1 << 12, 1 << 15, 1 << 20] };

/// The kernel's methods against each other by time.
pub const EXPERIMENT: Experiment = Experiment {
    id: "lad-race",
    title: "Least absolute deviations kernel: the methods side by side",
    question: "How do the times of the methods compare, on the same lines in one run? The full profile goes to 2^20 \
               lines.",
    claims: &["theorem-4.5"],
    families: &["random_lines"],
    real_inputs: &[],
    sizes: SIZES,
    instances: PerProfile::both(1),
    variants: &[
        Variant {
            id: "by_slope_selection",
            title: "Slope selection (the paper's search)",
            largest: PerProfile::both(usize::MAX),
        },
        Variant { id: "by_line_search", title: "Line searches", largest: PerProfile::both(usize::MAX) },
        Variant { id: "by_pruning", title: "Pruning", largest: PerProfile::both(usize::MAX) },
    ],
    measure: lad_scaling::measure,
    table: Tabulated::MedianAtLargest,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile::both(3), prepare: lad_scaling::prepare }),
    fits: &[],
};
