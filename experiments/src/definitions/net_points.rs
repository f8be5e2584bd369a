//! What Theorem 4.7 reads, against the number of points.

use super::length_ratio::{digest, verdict};
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Tabulated, Variant};
use crate::families::clouds::Cloud;
use crate::fit::GrowthModel;
use zonotope::enclosing::min_total_length::Method;
use zonotope::tally::OperationCounts;

/// The precision.
const EPSILON: f64 = 0.5;

const FAMILIES: &[&str] = &["ball_2", "ball_3", "sphere_3"];

/// What Theorem 4.7 reads, against the number of points.
pub const EXPERIMENT: Experiment = Experiment {
    id: "net-points",
    title: "Least total length along the paper's net: growth with the number of points",
    question: "The paper's net for epsilon = 1/2, in the plane and in space. The points that are read, which is the \
               part of the time of Theorem 4.7 that depends on their number: linear in it for a given precision. \
               Points are read a few times in all, besides a working set that does not grow with them.",
    claims: &["theorem-4.7"],
    families: FAMILIES,
    real_inputs: &[],
    sizes: PerProfile {
        quick: &[1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14],
        full: &[1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15, 1 << 16, 1 << 17, 1 << 18],
    },
    instances: PerProfile::both(3),
    variants: &[Variant { id: "papers_net", title: "The paper's net", largest: PerProfile::both(usize::MAX) }],
    measure,
    table: Tabulated::MedianAtLargest,
    timing: None,
    fits: &[FitPlan::of_operations("papers_net", FAMILIES)
        .of(Quantity::Count("point_read"))
        .within(Bound::of_paper(GrowthModel::Linear, "Theorem 4.7"))
        .at_least(GrowthModel::Linear)],
};

fn measure(case: &Case) -> Result<Measurement, String> {
    match case.cloud()? {
        Cloud::Plane(points) => measure_in(&points),
        Cloud::Space(points) => measure_in(&points),
        Cloud::Four(_) => Err("a net of four dimensions is too large".to_owned()),
    }
}

fn measure_in<const D: usize>(points: &[[f64; D]]) -> Result<Measurement, String> {
    let mut counts = OperationCounts::default();
    let answer = Method::PapersNet.solve(points, EPSILON, &mut counts).map_err(|error| error.to_string())?;
    Ok(Measurement::new(&counts, digest(&answer), verdict(&answer, EPSILON))
        .with_value("directions", answer.effort.rows as f64)
        .with_value("generators", answer.body.generators().len() as f64))
}
