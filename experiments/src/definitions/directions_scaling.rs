//! Size and time of the linear programs of 4.2 against the number of directions.

use super::fixed_directions_methods;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing};
use crate::fit::GrowthModel;
use families::clouds::{self, Cloud};

const SIZES: PerProfile<&[usize]> =
    PerProfile { quick: &[6, 8, 12, 16, 24, 32], full: &[6, 8, 12, 16, 24, 32, 48, 64, 96] };

/// The place of the bound on the program: the theorem says k^O(d), and the factor of d is ours.
const WITH_FACTOR: &str = "Theorem 4.6 with k^(2d)";

/// Points of each instance.
const POINTS: usize = 400;

/// Size and time of the linear programs of 4.2 against the number of directions.
pub const EXPERIMENT: Experiment = Experiment {
    id: "directions-scaling",
    title: "Along given directions: growth with the number of directions",
    question: "How many rows have the linear programs, and what does Theorem 4.6 read? n is the number k of \
               directions; there are 400 points in two, three and four dimensions. `rows` are those of the program \
               with all normals, of the paper's program, and of the one with normals as they are needed; \
               `share_of_bound` is the part of the rows that the number of normals allows, which is smaller where the \
               extreme points run out; `share_of_scan` the points read over n C(k, d - 1), a read for each point and \
               normal; `share_of_program` the entries that the engine reads in its steps over k^(2d), the bound of the \
               theorem with 2 for the factor in its power, fixed before the counts were seen. `relative_gap` is the \
               proven distance from the optimum.",
    claims: &["theorem-4.6", "linear-program", "summary-fixed-directions"],
    families: FAMILIES,
    sizes: SIZES,
    instances: PerProfile::both(2),
    variants: &fixed_directions_methods::variants(
        PerProfile { quick: 24, full: 48 },
        PerProfile { quick: 24, full: 32 },
    ),
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile { quick: 2, full: 3 }, prepare }),
    fits: &[
        share("papers_program", "share_of_bound").within(Bound::of_paper(GrowthModel::Constant, "section 4.2")),
        share("papers_program", "share_of_scan")
            .within(Bound::of_paper(GrowthModel::Constant, "Theorem 4.6"))
            .at_least(GrowthModel::Constant),
        share("papers_program", "share_of_program").within(Bound::of_paper(GrowthModel::Constant, WITH_FACTOR)),
        share("support_form", "share_of_bound").within(Bound::own(GrowthModel::Constant)),
        size("papers_program", Quantity::Value("rows")),
        size("papers_program", Quantity::Count("entry_read")),
        size("support_form", Quantity::Value("rows")),
        size("by_row_generation", Quantity::Value("rows")),
        size("by_row_generation", Quantity::Count("entry_read")),
    ],
    ..Experiment::COUNTED
};

const FAMILIES: &[&str] = &["ball_2", "sphere_2", "ball_3", "sphere_3", "ball_4", "sphere_4"];

const fn share(variant: &'static str, value: &'static str) -> FitPlan {
    FitPlan::new(Quantity::Value(value), variant, FAMILIES, GrowthModel::ALL)
}

const fn size(variant: &'static str, quantity: Quantity) -> FitPlan {
    FitPlan::new(quantity, variant, FAMILIES, GrowthModel::POWERS)
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
