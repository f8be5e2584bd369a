//! Passes and time of 4.2 against the number of points.

use super::fixed_directions_methods;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing};
use crate::fit::GrowthModel;

const SIZES: PerProfile<&[usize]> = PerProfile {
    quick: &[1 << 8, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14],
    full: &[1 << 8, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 16, 1 << 17, 1 << 18, 1 << 19, 1 << 20],
};

const FAMILIES: &[&str] = &["ball_3", "sphere_3"];

/// Directions of each instance.
const DIRECTIONS: usize = 10;

/// Passes and time of 4.2 against the number of points.
pub const EXPERIMENT: Experiment = Experiment {
    id: "points-scaling",
    title: "Along given directions: growth with the number of points",
    question: "How often are the points read, against their number? There are 10 directions in space; `passes` are \
               the readings of all points, `scan_read` the points read by a scan along all normals, as Theorem 4.6 \
               makes it for two of the forms (once for each normal, so that the count tells how many are scanned), and \
               `point_read` all others.",
    claims: &["theorem-4.6"],
    families: FAMILIES,
    sizes: SIZES,
    instances: PerProfile::both(2),
    variants: &fixed_directions_methods::variants(PerProfile::both(1 << 14), PerProfile::both(1 << 14)),
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile { quick: 2, full: 3 }, prepare }),
    fits: &[
        FitPlan::of_operations("papers_program", FAMILIES)
            .of(Quantity::Count("scan_read"))
            .within(Bound::of_paper(GrowthModel::Linear, "Theorem 4.6"))
            .at_least(GrowthModel::Linear),
        FitPlan::of_operations("by_row_generation", FAMILIES)
            .of(Quantity::Count("point_read"))
            .at_least(GrowthModel::Linear),
        FitPlan::of_operations("by_row_generation", FAMILIES).of(Quantity::Time("total")),
    ],
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    fixed_directions_methods::measure(case, &case.cloud()?, DIRECTIONS)
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    Ok(fixed_directions_methods::prepare(case, case.cloud()?, DIRECTIONS))
}
