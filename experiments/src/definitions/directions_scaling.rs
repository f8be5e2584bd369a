//! Size and time of the linear programs of 4.2 against the number of directions.

use super::fixed_directions_methods;
use crate::definition::{Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Tabulated, TimedWork, Timing};
use crate::families::clouds::{self, Cloud};
use crate::fit::GrowthModel;

const SIZES: PerProfile<&[usize]> =
    PerProfile { quick: &[6, 8, 12, 16, 24, 32], full: &[6, 8, 12, 16, 24, 32, 48, 64, 96] };

/// Points of each instance.
const POINTS: usize = 400;

/// Size and time of the linear programs of 4.2 against the number of directions.
pub const EXPERIMENT: Experiment = Experiment {
    id: "directions-scaling",
    title: "Along given directions: growth with the number of directions",
    question: "How many rows have the linear programs? n is the number k of directions; there are 400 points in two, \
               three and four dimensions. `rows` are those of the program with all normals, of the paper's program, \
               and of the one with normals as they are needed; `share_of_bound` is the part of the rows that the \
               number of normals allows, which is smaller where the extreme points run out. `relative_gap` is the \
               proven distance from the optimum.",
    claims: &["theorem-4.6", "linear-program", "summary-fixed-directions"],
    families: FAMILIES,
    real_inputs: &[],
    sizes: SIZES,
    instances: PerProfile { quick: 1, full: 2 },
    variants: &fixed_directions_methods::variants(
        PerProfile { quick: 24, full: 48 },
        PerProfile { quick: 24, full: 32 },
    ),
    measure,
    table: Tabulated::MedianAtLargest,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile { quick: 2, full: 3 }, prepare }),
    fits: &[
        fit("papers_program", Quantity::Value("share_of_bound"), Some(GrowthModel::Constant)),
        fit("support_form", Quantity::Value("share_of_bound"), Some(GrowthModel::Constant)),
        fit("papers_program", Quantity::Value("rows"), None),
        fit("support_form", Quantity::Value("rows"), None),
        fit("by_row_generation", Quantity::Value("rows"), None),
    ],
};

const FAMILIES: &[&str] = &["ball_2", "sphere_2", "ball_3", "sphere_3", "ball_4", "sphere_4"];

const fn fit(variant: &'static str, quantity: Quantity, bound: Option<GrowthModel>) -> FitPlan {
    let models = if bound.is_some() { GrowthModel::ALL } else { GrowthModel::POWERS };
    FitPlan { quantity, variant, families: FAMILIES, models, bound }
}

fn cloud(case: &Case) -> Result<Cloud, String> {
    let family = clouds::find(case.family).ok_or_else(|| format!("no points are called {}", case.family))?;
    Ok((family.generate)(POINTS, case.instance_seed))
}

fn measure(case: &Case) -> Result<Measurement, String> {
    fixed_directions_methods::measure(case, &cloud(case)?, case.n)
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    Ok(fixed_directions_methods::prepare(case, cloud(case)?, case.n))
}
