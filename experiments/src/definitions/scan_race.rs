//! The whole of 4.2 against its scan for extreme points alone, as the number of points grows.

use std::collections::BTreeSet;

use super::fixed_directions_methods::{digest, directions, solve};
use crate::definition::{Case, Experiment, Measurement, PerProfile, TimedWork, Timing, Variant, Verdict};
use crate::seed::Digest;
use families::clouds::Cloud;
use zonotope::enclosing::fixed_directions::{FixedDirections, papers_program::extreme_points_of};
use zonotope::interop::verifier::check_min_length_dirs_bounds;
use zonotope::tally::OperationCounts;

const SIZES: PerProfile<&[usize]> =
    PerProfile { quick: &[1 << 12, 1 << 14, 1 << 16], full: &[1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20] };

/// Directions of each instance.
const DIRECTIONS: usize = 50;

const SCAN: &str = "extreme_point_scan";

/// The whole of 4.2 against its scan for extreme points alone, as the number of points grows.
pub const EXPERIMENT: Experiment = Experiment {
    id: "scan-race",
    title: "Along 50 directions: the zonotope in less time than the paper's scan of the points",
    question: "Does the whole answer take less time than the paper's scan of the points alone? The paper reads all \
               points along each facet normal of 50 directions in space before its linear program begins; with \
               normals as they are needed the answer, proofs included, stands beside that scan: compare `total` of \
               the two variants. `extreme_points` is what the scan finds.",
    claims: &["theorem-4.6", "extreme-points-suffice"],
    families: &["ball_3", "sphere_3"],
    sizes: SIZES,
    instances: PerProfile { quick: 1, full: 2 },
    variants: &[
        Variant::at_all_sizes(SCAN, "Scan for extreme points"),
        Variant::at_all_sizes("by_row_generation", "Normals as they are needed"),
    ],
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile { quick: 1, full: 3 }, prepare }),
    ..Experiment::COUNTED
};

fn points(case: &Case) -> Result<Vec<[f64; 3]>, String> {
    match case.cloud()? {
        Cloud::Space(points) => Ok(points),
        _ => Err("the race is in space".to_owned()),
    }
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let (points, directions, weights) = (points(case)?, directions::<3>(case, DIRECTIONS), vec![1.0; DIRECTIONS]);
    let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    let answer = solve("by_row_generation", &problem, &mut counts)?;
    if case.variant != SCAN {
        let verdict =
            Verdict::of_verifier("check_min_length_dirs_bounds", check_min_length_dirs_bounds(&problem, &answer));
        return Ok(Measurement::new(&counts, digest(&answer), verdict)
            .with_value("passes", answer.effort.passes as f64)
            .with_value("relative_gap", answer.relative_gap()));
    }
    let extreme = extreme_points_of(&problem);
    let among: BTreeSet<usize> = extreme.iter().copied().collect();
    let is_kept = match answer.multipliers.iter().find(|force| !among.contains(&force.point)) {
        Some(force) => Err(format!("a force acts at point {}, which is not among them", force.point)),
        None => Ok(()),
    };
    let verdict = Verdict::of_check("forces act at extreme points", is_kept);
    Ok(Measurement::new(&OperationCounts::default(), digest_of_places(&extreme), verdict)
        .with_value("extreme_points", extreme.len() as f64))
}

fn digest_of_places(places: &[usize]) -> u64 {
    let places: Vec<f64> = places.iter().map(|&place| place as f64).collect();
    Digest::default().floats(&places).finish()
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let (points, directions, weights) = (points(case)?, directions::<3>(case, DIRECTIONS), vec![1.0; DIRECTIONS]);
    let is_scan = case.variant == SCAN;
    Ok(Box::new(move |stopwatch| {
        let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
        if is_scan {
            return Ok(digest_of_places(&stopwatch.lap("total", || extreme_points_of(&problem))));
        }
        let answer = stopwatch.lap("total", || solve("by_row_generation", &problem, &mut ()))?;
        Ok(digest(&answer))
    }))
}
