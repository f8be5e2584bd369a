//! Orientation tests and time of the convex hull against the number of points.

use super::{HULL_FAMILIES, SCALING_FAMILIES, SCALING_SIZES};
use crate::definition::{
    Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::hull::{ConvexHull, HullError, Method};
use zonotope::interop::verifier::check_convex_hull;
use zonotope::tally::{OperationCounts, Tally};

/// Orientation tests and time of the convex hull against the number of points.
pub const EXPERIMENT: Experiment = Experiment {
    id: "hull-scaling",
    title: "Convex hull: growth with the number of points",
    question: "How many orientation tests does each method need, with many points on the hull or few? The sort of \
               the monotone chain shows in the times alone.",
    claims: &["hull-suffices"],
    families: SCALING_FAMILIES,
    sizes: SCALING_SIZES,
    instances: PerProfile::both(2),
    variants: &[
        Variant::at_all_sizes("by_discarding", "Discarding and buckets"),
        Variant::at_all_sizes("by_monotone_chain", "Monotone chain"),
        Variant { id: "brute_force", title: "Gift wrapping", largest: PerProfile::both(1 << 11) },
    ],
    measure,
    timing: Some(Timing { sizes: SCALING_SIZES, repetitions: PerProfile::both(5), prepare }),
    fits: &[
        FitPlan::of_operations("by_monotone_chain", SCALING_FAMILIES)
            .of(Quantity::Count("turn"))
            .within(Bound::own(GrowthModel::Linear))
            .at_least(GrowthModel::Linear),
        FitPlan::of_operations("brute_force", HULL_FAMILIES)
            .of(Quantity::Count("turn"))
            .within(Bound::own(GrowthModel::Quadratic)),
        FitPlan::of_operations("by_monotone_chain", SCALING_FAMILIES).of(Quantity::Time("total")),
    ],
    ..Experiment::COUNTED
};

fn solve(variant: &str, points: &[[f64; 2]], tally: &mut impl Tally) -> Result<ConvexHull, HullError> {
    Method::from_id(variant).unwrap_or_default().convex_hull(points, tally)
}

fn digest(hull: &ConvexHull) -> u64 {
    Digest::default().floats(hull.vertices().as_flattened()).finish()
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let points = case.points()?;
    let mut counts = OperationCounts::default();
    let hull = solve(case.variant, &points, &mut counts).map_err(|error| error.to_string())?;
    let verdict = Verdict::of_verifier("check_convex_hull", check_convex_hull(&points, &hull));
    Ok(Measurement::new(&counts, digest(&hull), verdict).with_value("hull_vertices", hull.vertex_count() as f64))
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let points = case.points()?;
    let variant = case.variant;
    Ok(Box::new(move |stopwatch| {
        let hull = stopwatch.lap("total", || solve(variant, &points, &mut ())).map_err(|error| error.to_string())?;
        Ok(digest(&hull))
    }))
}
