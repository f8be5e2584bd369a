//! Operations and time of slope selection against the number of lines.

use crate::definition::{
    Bound, Case, Experiment, FitPlan, Measurement, PerProfile, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::arrangement::LineArrangement;
use zonotope::arrangement::slope_selection::{ArrangementVertex, Method, kth_leftmost_vertex};
use zonotope::tally::OperationCounts;

const FAMILIES: &[&str] =
    &["random_lines", "lattice_lines", "near_parallel_lines", "concurrent_lines", "symmetric_lines"];

/// Up to this many lines the exact twin, which sorts all vertices, is the reference.
const TWIN_LIMIT: usize = 1 << 8;

/// Operations and time of slope selection against the number of lines.
pub const EXPERIMENT: Experiment = Experiment {
    id: "slope-selection-scaling",
    title: "Slope selection: growth with the number of lines",
    question: "How do operations and time of finding the median vertex of n lines grow, on ordinary lines and on \
               degenerate ones?",
    claims: &["theorem-4.5", "halving-search"],
    families: FAMILIES,
    sizes: super::SCALING_SIZES,
    instances: PerProfile { quick: 12, full: 4 },
    variants: &[Variant {
        id: "randomized",
        title: "Randomised, by counting inversions",
        largest: PerProfile { quick: 1 << 13, full: 1 << 17 },
    }],
    measure,
    timing: Some(Timing { sizes: super::SCALING_SIZES, repetitions: PerProfile { quick: 3, full: 5 }, prepare }),
    fits: &[FitPlan::of_operations("randomized", FAMILIES)
        .within(Bound::of_paper(GrowthModel::Linearithmic, "section 4.1"))
        .at_least(GrowthModel::Linear)],
    ..Experiment::COUNTED
};

fn arrangement(case: &Case) -> Result<LineArrangement<'static>, String> {
    let rows: Vec<[f64; 3]> = case.lines()?.into_iter().map(|([a, b], c)| [a, b, c]).collect();
    LineArrangement::from_rows(&rows).map_err(|error| error.to_string())
}

fn median_rank(arrangement: &LineArrangement) -> u64 {
    arrangement.vertex_count().div_ceil(2)
}

fn digest(vertex: &ArrangementVertex) -> u64 {
    Digest::default().floats(&[vertex.x()]).finish()
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let arrangement = arrangement(case)?;
    let rank = median_rank(&arrangement);
    let mut counts = OperationCounts::default();
    let vertex = kth_leftmost_vertex(&arrangement, rank, case.seed, &mut counts).map_err(|error| error.to_string())?;
    let (reference, expected) = if case.n <= TWIN_LIMIT {
        let all = Method::BruteForce.vertices(&arrangement, &[rank], case.seed);
        (Method::BruteForce.id(), all.map(|mut vertices| vertices.swap_remove(0)))
    } else {
        ("randomized with another seed", kth_leftmost_vertex(&arrangement, rank, !case.seed, &mut ()))
    };
    let (found, expected) = (vertex.exact_x(), expected.map_err(|error| error.to_string())?.exact_x());
    let same = if found == expected { Ok(()) } else { Err(format!("the abscissa is {found}, expected {expected}")) };
    let verdict = Verdict::of_check(&format!("slope_selection::{reference}"), same);
    Ok(Measurement::new(&counts, digest(&vertex), verdict).with_value("vertices", arrangement.vertex_count() as f64))
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let arrangement = arrangement(case)?;
    let (rank, seed) = (median_rank(&arrangement), case.seed);
    Ok(Box::new(move |stopwatch| {
        let vertex = stopwatch
            .lap("total", || kth_leftmost_vertex(&arrangement, rank, seed, &mut ()))
            .map_err(|error| error.to_string())?;
        Ok(digest(&vertex))
    }))
}
