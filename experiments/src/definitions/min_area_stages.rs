//! The shares of the stages of 4.1 in operations and time: hull, farthest vertices, lines, kernel, output.

use super::{SCALING_FAMILIES, min_area_scaling};
use crate::definition::{Case, Experiment, Measurement, PerProfile, TimedWork, Timing, Variant, Verdict};
use zonotope::enclosing::bisectors::Bisectors;
use zonotope::enclosing::min_area_zonogon::Method;
use zonotope::hull::antipodal::farthest_vertices;
use zonotope::hull::convex_hull;
use zonotope::interop::verifier::check_min_area;
use zonotope::tally::OperationCounts;

const SIZES: PerProfile<&[usize]> =
    PerProfile { quick: &[1 << 10, 1 << 14], full: &[1 << 10, 1 << 14, 1 << 17, 1 << 20] };

/// Up to this many points answers are verified here; `min-area-scaling` verifies larger ones on the same instances.
const VERIFIED_SIZE: usize = 1 << 14;

/// The shares of the stages of 4.1 in operations and time.
pub const EXPERIMENT: Experiment = Experiment {
    id: "min-area-stages",
    title: "Minimum-area enclosing zonogon: cost of each stage",
    question: "What does each stage cost, with few points on the hull and with all of them on it? Laps: hull, \
               antipodal, lines (their frame: the lines are made as the kernel reads them), kernel, and whole, the \
               finished algorithm in one call; whole less the other four is the output (Z(O), rounding outward, \
               lower bound). Values: operations of each stage.",
    claims: &["theorem-4.5"],
    families: SCALING_FAMILIES,
    real_inputs: &["airports", "canada"],
    sizes: SIZES,
    instances: PerProfile::both(1),
    variants: &[Variant::at_all_sizes("by_pruning", "Pruning")],
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile { quick: 5, full: 7 }, prepare }),
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let points = case.points()?;
    let mut stages = [OperationCounts::default(); 3];
    let [hull_counts, antipodal_counts, kernel_counts] = &mut stages;
    let hull = convex_hull(&points, hull_counts).map_err(|error| error.to_string())?;
    let farthest = farthest_vertices(&hull, antipodal_counts);
    Method::Pruning.kernel().minimize(&Bisectors::new(&hull, &farthest).kernel_problem(), case.seed, kernel_counts);

    let mut counts = OperationCounts::default();
    let answer = Method::Pruning.solve(&points, case.seed, &mut counts).map_err(|error| error.to_string())?;
    let verdict = if case.n <= VERIFIED_SIZE {
        Verdict::of_verifier("check_min_area", check_min_area(&points, &answer))
    } else {
        Verdict::Unchecked(format!("beyond {VERIFIED_SIZE} points min-area-scaling verifies this instance"))
    };
    let measurement = Measurement::new(&counts, min_area_scaling::digest(&answer), verdict)
        .with_value("hull_vertices", hull.vertex_count() as f64);
    let named = ["hull_operations", "antipodal_operations", "kernel_operations"].into_iter().zip(&stages);
    Ok(named.fold(measurement, |measurement, (name, counts)| {
        let total: u64 = counts.iter().map(|(_, count)| count).sum();
        measurement.with_value(name, total as f64)
    }))
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let points = case.points()?;
    let seed = case.seed;
    Ok(Box::new(move |stopwatch| {
        let hull = stopwatch.lap("hull", || convex_hull(&points, &mut ())).map_err(|error| error.to_string())?;
        let farthest = stopwatch.lap("antipodal", || farthest_vertices(&hull, &mut ()));
        let problem = stopwatch.lap("lines", || Bisectors::new(&hull, &farthest).kernel_problem());
        stopwatch.lap("kernel", || Method::Pruning.kernel().minimize(&problem, seed, &mut ()));
        let answer = stopwatch
            .lap("whole", || Method::Pruning.solve(&points, seed, &mut ()))
            .map_err(|error| error.to_string())?;
        Ok(min_area_scaling::digest(&answer))
    }))
}
