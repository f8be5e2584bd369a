//! Shared parts of the experiments on given directions: the three forms as variants, directions, and what is recorded
//! of an answer.

use crate::definition::{Case, Measurement, PerProfile, TimedWork, Variant, Verdict};
use crate::seed::{self, Digest};
use families::clouds::{Cloud, on_sphere};
use zonotope::enclosing::fixed_directions::{DirectedZonotope, Enclosure, FixedDirections, Method};
use zonotope::interop::verifier::{check_min_length_dirs, check_min_length_dirs_bounds};
use zonotope::tally::{Operation, OperationCounts, Tally};

/// An answer whose value exceeds its proven lower bound by more, relatively, counts as wrong.
const LARGEST_GAP: f64 = 1e-10;

/// Up to this many points times directions each point is proven inside.
const CONTAINED_SIZE: usize = 300;

/// The three forms, the engine's two up to sizes of their own.
pub(super) const fn variants(papers_program: PerProfile<usize>, support_form: PerProfile<usize>) -> [Variant; 3] {
    [
        variant(Method::PapersProgram, papers_program),
        variant(Method::SupportForm, support_form),
        variant(Method::RowGeneration, PerProfile::both(usize::MAX)),
    ]
}

/// A method as a variant.
const fn variant(method: Method, largest: PerProfile<usize>) -> Variant {
    Variant { id: method.id(), title: method.title(), largest }
}

/// `k` random unit vectors that belong to the instance of a case.
pub(super) fn directions<const D: usize>(case: &Case, k: usize) -> Vec<[f64; D]> {
    on_sphere(k, seed::seed_of(case.instance_seed, "directions"))
}

/// The answer of a variant.
pub(super) fn solve<const D: usize>(
    variant: &str,
    problem: &FixedDirections<'_, D>,
    tally: &mut impl Tally,
) -> Result<DirectedZonotope<D>, String> {
    let method = Method::from_id(variant).ok_or_else(|| format!("no method is called {variant}"))?;
    match method.solve(problem, tally).map_err(|error| error.to_string())? {
        Enclosure::Optimal(zonotope) => Ok(zonotope),
        Enclosure::Infeasible(_) => Err("the directions do not span".to_owned()),
    }
}

/// The hash of an answer.
pub(super) fn digest<const D: usize>(answer: &DirectedZonotope<D>) -> u64 {
    let digest = Digest::default().floats(&answer.center).floats(&answer.coefficients);
    digest.floats(&[answer.value, answer.lower_bound]).finish()
}

/// Runs a variant on a case with `k` directions of weight 1, and checks value, lower bound and, if that is not too
/// much, every point.
pub(super) fn measure(case: &Case, cloud: &Cloud, k: usize) -> Result<Measurement, String> {
    match cloud {
        Cloud::Plane(points) => measure_in(case, points, k),
        Cloud::Space(points) => measure_in(case, points, k),
        Cloud::Four(points) => measure_in(case, points, k),
    }
}

fn measure_in<const D: usize>(case: &Case, points: &[[f64; D]], k: usize) -> Result<Measurement, String> {
    let (directions, weights) = (directions::<D>(case, k), vec![1.0; k]);
    let problem = FixedDirections::new(points, &directions, &weights).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    let answer = solve(case.variant, &problem, &mut counts)?;
    let verdict = if answer.relative_gap() > LARGEST_GAP {
        Verdict::Wrong(format!("the bounds are {:e} apart", answer.relative_gap()))
    } else if points.len() * k <= CONTAINED_SIZE {
        let checked = check_min_length_dirs(&problem, &Enclosure::Optimal(answer.clone()));
        Verdict::of_verifier("check_min_length_dirs", checked)
    } else {
        Verdict::of_verifier("check_min_length_dirs_bounds", check_min_length_dirs_bounds(&problem, &answer))
    };
    let measurement = Measurement::new(&counts, digest(&answer), verdict);
    let measurement = match most_rows(case.variant, k, D) {
        Some(most) => measurement.with_value("share_of_bound", answer.effort.rows as f64 / most),
        None => measurement,
    };
    let measurement = match case.variant {
        "papers_program" => {
            let reads = |operation| counts.get(operation) as f64;
            let scan = points.len() as f64 * normals(k, D) as f64;
            measurement
                .with_value("share_of_scan", reads(Operation::ScanRead) / scan)
                .with_value("share_of_program", reads(Operation::EntryRead) / (k as f64).powi(2 * D as i32))
        }
        _ => measurement,
    };
    Ok(measurement
        .with_value("rows", answer.effort.rows as f64)
        .with_value("rounds", answer.effort.rounds as f64)
        .with_value("passes", answer.effort.passes as f64)
        .with_value("relative_gap", answer.relative_gap()))
}

/// The number of subsets of d - 1 directions, each of which has a normal.
fn normals(k: usize, dimension: usize) -> usize {
    (0..dimension - 1).fold(1, |count, i| count * (k - i) / (i + 1))
}

/// The most rows that the analysis allows: one for each normal and side, or d equations and 2k bounds for the point
/// that is extreme there.
fn most_rows(variant: &str, k: usize, dimension: usize) -> Option<f64> {
    let normals = normals(k, dimension);
    let rows = match variant {
        "papers_program" => 2 * normals * (dimension + 2 * k),
        "support_form" => 2 * normals,
        _ => return None,
    };
    Some(rows as f64)
}

/// The same without counting, for the clock.
pub(super) fn prepare(case: &Case, cloud: Cloud, k: usize) -> TimedWork {
    match cloud {
        Cloud::Plane(points) => prepare_in(case, points, k),
        Cloud::Space(points) => prepare_in(case, points, k),
        Cloud::Four(points) => prepare_in(case, points, k),
    }
}

fn prepare_in<const D: usize>(case: &Case, points: Vec<[f64; D]>, k: usize) -> TimedWork {
    let (directions, weights) = (directions::<D>(case, k), vec![1.0; k]);
    let variant = case.variant;
    Box::new(move |stopwatch| {
        let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
        let answer = stopwatch.lap("total", || solve(variant, &problem, &mut ()))?;
        Ok(digest(&answer))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The scan reads each point along each of the C(8, 2) normals, and the engine reads at least each row's two
    /// entries once.
    #[test]
    fn the_papers_program_counts_its_scan_and_its_engine() {
        let points = on_sphere::<3>(100, 5);
        let case = Case::new(1, "directions-scaling", "sphere_3", "papers_program", 8, 0);
        let measured = measure(&case, &Cloud::Space(points), 8).expect("100 points");
        assert!(measured.counts["scan_read"] == 100 * 28, "{:?}", measured.counts);
        assert!(measured.counts["entry_read"] as f64 >= 2.0 * measured.values["rows"], "{:?}", measured.counts);
        assert!(measured.values["share_of_scan"] == 1.0);
    }
}
