//! The gap between length and lower bound, round by round.

use crate::definition::{Case, Experiment, Measurement, PerProfile, TimedWork, Timing, Variant, Verdict};
use crate::seed::Digest;
use families::clouds::{self, Cloud};
use zonotope::enclosing::min_total_length::{Method, MinLengthZonotope};
use zonotope::tally::{OperationCounts, Tally};

const SIZES: PerProfile<&[usize]> = PerProfile { quick: &[100, 200], full: &[100, 200, 500, 1000] };

/// The precision that is asked for in the plane and in space.
const PRECISION: [f64; 2] = [1e-9, 1e-6];

/// Gaps, and the values that tell the first round in which each of them was reached.
pub const REACHED: [(f64, &str); 9] = [
    (1e-1, "rounds_to_1e-1"),
    (1e-2, "rounds_to_1e-2"),
    (1e-3, "rounds_to_1e-3"),
    (1e-4, "rounds_to_1e-4"),
    (1e-5, "rounds_to_1e-5"),
    (1e-6, "rounds_to_1e-6"),
    (1e-7, "rounds_to_1e-7"),
    (1e-8, "rounds_to_1e-8"),
    (1e-9, "rounds_to_1e-9"),
];

/// The gap between length and lower bound, round by round.
pub const EXPERIMENT: Experiment = Experiment {
    id: "gap-curve",
    title: "Least total length over all directions: the gap round by round",
    question: "In how many rounds does the gap between length and lower bound close? There are n points on a circle \
               of the plane, and 3 n / 10 of them on a sphere of space: all of them on the hull. `rounds_to_1e-6` is \
               the first round after which the length of the best zonotope so far is within a relative 1e-6 of the \
               proven lower bound. In the plane a round is a number of centres, in space a Newton step.",
    claims: &["theorem-4.7", "summary-approximate-length"],
    families: &["sphere_2", "sphere_3"],
    sizes: SIZES,
    instances: PerProfile { quick: 1, full: 2 },
    variants: &[Variant::at_all_sizes("by_column_generation", "Directions as they are needed")],
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile { quick: 1, full: 2 }, prepare }),
    ..Experiment::COUNTED
};

fn cloud(case: &Case) -> Result<Cloud, String> {
    let family = clouds::find(case.family).ok_or_else(|| format!("no points are called {}", case.family))?;
    let count = if case.family == "sphere_3" { 3 * case.n / 10 } else { case.n };
    Ok((family.generate)(count, case.instance_seed))
}

fn measure(case: &Case) -> Result<Measurement, String> {
    match cloud(case)? {
        Cloud::Plane(points) => measure_in(&points),
        Cloud::Space(points) => measure_in(&points),
        Cloud::Four(_) => Err("four dimensions are not in this experiment".to_owned()),
    }
}

fn precision(dimension: usize) -> f64 {
    PRECISION[usize::from(dimension > 2)]
}

fn solve<const D: usize>(points: &[[f64; D]], tally: &mut impl Tally) -> Result<MinLengthZonotope<D>, String> {
    Method::default().solve(points, precision(D), tally).map_err(|error| error.to_string())
}

fn measure_in<const D: usize>(points: &[[f64; D]]) -> Result<Measurement, String> {
    let mut counts = OperationCounts::default();
    let answer = solve(points, &mut counts)?;
    let is_kept = if answer.ratio() <= 1.0 + precision(D) {
        Ok(())
    } else {
        Err(format!("the ratio {} is above 1 + {}", answer.ratio(), precision(D)))
    };
    let measurement = Measurement::new(&counts, digest(&answer), Verdict::of_check("the proven ratio", is_kept))
        .with_value("excess", answer.value / answer.lower_bound - 1.0)
        .with_value("forces", answer.proof.multipliers.len() as f64)
        .with_value("rounds", answer.effort.progress.len() as f64);
    let reached = REACHED.iter().filter_map(|(gap, name)| {
        let round = answer.effort.progress.iter().position(|[upper, lower]| *upper <= (1.0 + gap) * lower)?;
        Some((name, (round + 1) as f64))
    });
    Ok(reached.fold(measurement, |measurement, (name, round)| measurement.with_value(name, round)))
}

fn digest<const D: usize>(answer: &MinLengthZonotope<D>) -> u64 {
    let digest = Digest::default().floats(&answer.body.center());
    digest.floats(answer.body.generators().as_flattened()).floats(&[answer.value, answer.lower_bound]).finish()
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    match cloud(case)? {
        Cloud::Plane(points) => Ok(prepare_in(points)),
        Cloud::Space(points) => Ok(prepare_in(points)),
        Cloud::Four(_) => Err("four dimensions are not in this experiment".to_owned()),
    }
}

fn prepare_in<const D: usize>(points: Vec<[f64; D]>) -> TimedWork {
    Box::new(move |stopwatch| {
        let answer = stopwatch.lap("total", || solve(&points, &mut ()))?;
        Ok(digest(&answer))
    })
}
