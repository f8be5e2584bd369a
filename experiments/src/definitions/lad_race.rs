//! The kernel's methods against each other by time, on the same lines in one run.

use super::{kernel_methods, lad_scaling};
use crate::definition::{Experiment, PerProfile, Timing};

const SIZES: PerProfile<&[usize]> = PerProfile { quick: &[1 << 12, 1 << 15], full: &[1 << 12, 1 << 15, 1 << 20] };

/// The kernel's methods against each other by time.
pub const EXPERIMENT: Experiment = Experiment {
    id: "lad-race",
    title: "Least absolute deviations kernel: the methods side by side",
    question: "How do the times of the methods compare, on the same lines in one run? The full profile goes to 2^20 \
               lines.",
    claims: &["theorem-4.5"],
    families: &["random_lines"],
    sizes: SIZES,
    instances: PerProfile::both(1),
    variants: kernel_methods::VARIANTS,
    measure: lad_scaling::measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile::both(3), prepare: lad_scaling::prepare }),
    ..Experiment::COUNTED
};
