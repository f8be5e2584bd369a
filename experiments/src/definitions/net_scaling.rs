//! The reads of Theorem 4.7 of points and of matrices, against the precision.

use super::length_ratio::{digest, verdict};
use super::net_points::along_net;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Tabulated, Variant};
use crate::fit::GrowthModel;
use families::clouds::{self, Cloud};
use zonotope::enclosing::min_total_length::{Method, Net};
use zonotope::tally::{Operation, OperationCounts};

/// Points of each instance: so many that every net here is solved as a whole.
const POINTS: usize = 48;

/// The paper's program along the net, which is that of Theorem 4.7.
const PAPERS_PROGRAM: &str = "papers_program";

/// Row generation along the net, which is the workbench's own.
const ROW_GENERATION: &str = "by_row_generation";

/// The reads of Theorem 4.7 in the plane, against the precision.
pub const PLANE: Experiment = Experiment {
    id: "net-scaling",
    title: "Least total length along the paper's net of the plane: growth with the precision",
    question: "What does Theorem 4.7 read, against the precision? n is 1 / epsilon; there are 48 points. The theorem \
               solves the paper's program along the paper's net. `share_of_points` is the points that its scan reads \
               over their number times epsilon^-(d-1)^2, and `share_of_program` the entries that its engine reads \
               over epsilon^-(2d(d-1)), the bound of the theorem with 2 for the factor in its power, fixed before the \
               counts were seen. Beside it our own row generation is asked along the same net.",
    variants: &[
        Variant::at_all_sizes(PAPERS_PROGRAM, "The paper's program"),
        Variant::at_all_sizes(ROW_GENERATION, "Row generation"),
    ],
    families: &["sphere_2"],
    sizes: PerProfile::both(&[2, 4, 8, 16, 32, 64, 128]),
    fits: &[
        share("share_of_points", "Theorem 4.7"),
        share("share_of_program", "Theorem 4.7 with epsilon^(-2d(d-1))"),
        reads("scan_read", PAPERS_PROGRAM),
        reads("entry_read", PAPERS_PROGRAM),
        reads("entry_read", ROW_GENERATION),
    ],
    ..SPACE
};

/// The same in space, where nets soon are too large.
pub const SPACE: Experiment = Experiment {
    id: "net-scaling-in-space",
    title: "Least total length along the paper's net of space: growth with the precision",
    question: "What is read along the net of Theorem 4.7, against the precision? n is 1 / epsilon; there are 48 \
               points. `net_size` is the number of directions of the net, each two of which give a normal of the \
               paper's program: that is too large in space, so our own row generation is asked. The sizes are few, \
               over one doubling, and no law is fitted.",
    claims: &["theorem-4.7"],
    families: &["sphere_3"],
    only_full: &[],
    real_inputs: &[],
    refuses: |_| None,
    sizes: PerProfile::both(&[2, 3, 4]),
    instances: PerProfile { quick: 2, full: 4 },
    variants: &[Variant::at_all_sizes(ROW_GENERATION, "Row generation")],
    measure,
    table: Tabulated::MedianAtLargest,
    timing: None,
    fits: &[],
};

const fn share(value: &'static str, place: &'static str) -> FitPlan {
    FitPlan::new(Quantity::Value(value), PAPERS_PROGRAM, &["sphere_2"], GrowthModel::ALL)
        .within(Bound::of_paper(GrowthModel::Constant, place))
}

const fn reads(count: &'static str, variant: &'static str) -> FitPlan {
    FitPlan::new(Quantity::Count(count), variant, &["sphere_2"], GrowthModel::POWERS)
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let family = clouds::find(case.family).ok_or_else(|| format!("no points are called {}", case.family))?;
    match (case.variant, (family.generate)(POINTS, case.instance_seed)) {
        (PAPERS_PROGRAM, Cloud::Plane(points)) => by_papers_program(case, &points),
        (ROW_GENERATION, Cloud::Plane(points)) => by_row_generation(case, &points),
        (ROW_GENERATION, Cloud::Space(points)) => by_row_generation(case, &points),
        (variant, _) => Err(format!("{variant} is not asked along nets of so many dimensions")),
    }
}

fn by_papers_program(case: &Case, points: &[[f64; 2]]) -> Result<Measurement, String> {
    let inverse = case.n as f64;
    let size = Net::Paper.size(2, 1.0 / inverse);
    // two faces of so many cells, and the two axes
    let measured = along_net(points, (size - 2) / 2)?;
    let reads = |operation: Operation| measured.counts.get(operation.name()).copied().unwrap_or_default() as f64;
    let of_points = reads(Operation::ScanRead) / (points.len() as f64 * inverse);
    let of_program = reads(Operation::EntryRead) / inverse.powi(4);
    Ok(measured
        .with_value("net_size", size as f64)
        .with_value("share_of_points", of_points)
        .with_value("share_of_program", of_program))
}

fn by_row_generation<const D: usize>(case: &Case, points: &[[f64; D]]) -> Result<Measurement, String> {
    let epsilon = 1.0 / case.n as f64;
    let mut counts = OperationCounts::default();
    let answer = Method::PapersNet.solve(points, epsilon, &mut counts).map_err(|error| error.to_string())?;
    Ok(Measurement::new(&counts, digest(&answer), verdict(&answer, epsilon))
        .with_value("net_size", Net::Paper.size(D, epsilon) as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_program_along_the_net_scans_every_point_for_every_normal() {
        let measured = measure(&Case::new(1, PLANE.id, "sphere_2", PAPERS_PROGRAM, 4, 0)).expect("48 points");
        // cells of width 2/12 at most: 9 along a side, whose middles have the axes among them
        let normals = 2 * 9;
        assert_eq!(measured.counts["scan_read"], normals * POINTS as u64, "{:?}", measured.counts);
        assert!(measured.counts["entry_read"] > 0, "{:?}", measured.counts);
    }

    #[test]
    fn row_generation_along_the_net_reads_points_and_entries() {
        let measured = measure(&Case::new(1, PLANE.id, "sphere_2", ROW_GENERATION, 4, 0)).expect("48 points");
        assert!(measured.counts["point_read"] >= 2 * 2 * POINTS as u64, "{:?}", measured.counts);
        assert!(measured.counts["entry_read"] > 0, "{:?}", measured.counts);
    }
}
