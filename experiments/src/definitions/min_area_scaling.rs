//! Operations and time of the whole of 4.1, from points to a certified zonogon, against the number of points.

use super::{HULL_FAMILIES, SCALING_FAMILIES, SCALING_SIZES};
use crate::definition::{
    Bound, Case, Experiment, FitPlan, Measurement, PerProfile, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::enclosing::min_area_zonogon::{Method, MinAreaZonogon};
use zonotope::hull::convex_hull;
use zonotope::interop::verifier::check_min_area;
use zonotope::tally::OperationCounts;

/// Operations and time of the whole of 4.1 against the number of points.
pub const EXPERIMENT: Experiment = Experiment {
    id: "min-area-scaling",
    title: "Minimum-area enclosing zonogon: growth with the number of points",
    question: "How do operations and time of the whole of finding the zonogon grow with the number of points, with \
               each method of the kernel? The lap `hull` is the hull alone on the same points.",
    claims: &["theorem-4.5", "summary-min-area"],
    families: SCALING_FAMILIES,
    sizes: SCALING_SIZES,
    instances: PerProfile::both(2),
    variants: &[
        variant(Method::SlopeSelection, PerProfile { quick: 1 << 13, full: 1 << 16 }),
        variant(Method::Pruning, PerProfile::both(usize::MAX)),
        variant(Method::LineSearch, PerProfile::both(1 << 16)),
    ],
    measure,
    timing: Some(Timing { sizes: SCALING_SIZES, repetitions: PerProfile::both(3), prepare }),
    fits: &[
        FitPlan::of_operations("by_slope_selection", HULL_FAMILIES)
            .within(Bound::of_paper(GrowthModel::LinearLogSquared, "Theorem 4.5"))
            .at_least(GrowthModel::Linear),
        FitPlan::of_operations("by_pruning", SCALING_FAMILIES)
            .within(Bound::own(GrowthModel::Linearithmic))
            .at_least(GrowthModel::Linear),
        FitPlan::of_operations("by_line_search", HULL_FAMILIES),
    ],
    ..Experiment::COUNTED
};

/// Up to this many points every answer is verified. The exact check takes about 30 microseconds for each vertex of the
/// hull, so beyond only the first instance is.
const VERIFIED_SIZE: usize = 1 << 17;

/// A method as a variant, under the method's own name.
const fn variant(method: Method, largest: PerProfile<usize>) -> Variant {
    Variant { id: method.id(), title: method.title(), largest }
}

/// The method of a case, by the name of its variant.
pub(super) fn method(case: &Case) -> Result<Method, String> {
    Method::from_id(case.variant).ok_or_else(|| format!("no method for the least area is called {}", case.variant))
}

/// A hash of the zonogon and of both bounds of its area.
pub(super) fn digest(answer: &MinAreaZonogon) -> u64 {
    Digest::default()
        .floats(&answer.body.center())
        .floats(answer.body.generators().as_flattened())
        .floats(&[answer.value, answer.lower_bound])
        .finish()
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let method = method(case)?;
    let points = case.points()?;
    let mut counts = OperationCounts::default();
    let answer = method.solve(&points, case.seed, &mut counts).map_err(|error| error.to_string())?;
    let verdict = if case.n <= VERIFIED_SIZE || case.instance == 0 {
        Verdict::of_verifier("check_min_area", check_min_area(&points, &answer))
    } else {
        Verdict::Unchecked(format!("beyond {VERIFIED_SIZE} points the first instance is verified"))
    };
    Ok(Measurement::new(&counts, digest(&answer), verdict)
        .with_value("hull_vertices", answer.proof.hull().vertex_count() as f64)
        .with_value("relative_gap", answer.relative_gap()))
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let (method, seed) = (method(case)?, case.seed);
    let points = case.points()?;
    Ok(Box::new(move |stopwatch| {
        stopwatch.lap("hull", || convex_hull(&points, &mut ())).map_err(|error| error.to_string())?;
        let answer =
            stopwatch.lap("total", || method.solve(&points, seed, &mut ())).map_err(|error| error.to_string())?;
        Ok(digest(&answer))
    }))
}
