//! The reads of Theorem 4.7 of points and of matrices, against the precision.

use super::length_ratio::{digest, verdict};
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Tabulated, Variant};
use crate::fit::GrowthModel;
use families::clouds::{self, Cloud};
use zonotope::enclosing::min_total_length::{Method, Net};
use zonotope::tally::{Operation, OperationCounts};

/// Points of each instance: so many that every net here is solved as a whole.
const POINTS: usize = 48;

/// The reads of Theorem 4.7 in the plane, against the precision.
pub const PLANE: Experiment = Experiment {
    id: "net-scaling",
    title: "Least total length along the paper's net of the plane: growth with the precision",
    families: &["sphere_2"],
    sizes: PerProfile::both(&[2, 4, 8, 16, 32, 64, 128]),
    fits: &[
        share("share_of_points", "Theorem 4.7", &["sphere_2"]),
        share("share_of_program", "Theorem 4.7 with epsilon^(-2d(d-1))", &["sphere_2"]),
        reads("scan_read", &["sphere_2"]),
        reads("entry_read", &["sphere_2"]),
    ],
    ..SPACE
};

/// The same in space, where nets soon are too large.
pub const SPACE: Experiment = Experiment {
    id: "net-scaling-in-space",
    title: "Least total length along the paper's net of space: growth with the precision",
    question: "What does Theorem 4.7 read, against the precision? n is 1 / epsilon; there are 48 points. \
               `share_of_points` is the points that the scan reads over their number times epsilon^-(d-1)^2, and \
               `share_of_program` the entries that the linear programs read, with the directions that are looked at \
               for each multiplier, over epsilon^-(2d(d-1)), the bound of the theorem with 2 for the factor in its \
               power, fixed before the counts were seen. `net_size` is the number of directions of the net. In space \
               the sizes are few, over one doubling, and no law is fitted.",
    claims: &["theorem-4.7"],
    families: &["sphere_3"],
    only_full: &[],
    real_inputs: &[],
    refuses: |_| None,
    sizes: PerProfile::both(&[2, 3, 4]),
    instances: PerProfile { quick: 2, full: 4 },
    variants: &[Variant::at_all_sizes("papers_net", "The paper's net")],
    measure,
    table: Tabulated::MedianAtLargest,
    timing: None,
    fits: &[],
};

const fn share(value: &'static str, place: &'static str, families: &'static [&'static str]) -> FitPlan {
    FitPlan::new(Quantity::Value(value), "papers_net", families, GrowthModel::ALL)
        .within(Bound::of_paper(GrowthModel::Constant, place))
}

const fn reads(count: &'static str, families: &'static [&'static str]) -> FitPlan {
    FitPlan::new(Quantity::Count(count), "papers_net", families, GrowthModel::POWERS)
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let family = clouds::find(case.family).ok_or_else(|| format!("no points are called {}", case.family))?;
    match (family.generate)(POINTS, case.instance_seed) {
        Cloud::Plane(points) => measure_in(case, &points),
        Cloud::Space(points) => measure_in(case, &points),
        Cloud::Four(_) => Err("a net of four dimensions is too large".to_owned()),
    }
}

fn measure_in<const D: usize>(case: &Case, points: &[[f64; D]]) -> Result<Measurement, String> {
    let inverse = case.n as f64;
    let epsilon = 1.0 / inverse;
    let mut counts = OperationCounts::default();
    let answer = Method::PapersNet.solve(points, epsilon, &mut counts).map_err(|error| error.to_string())?;
    let reads = |operation| counts.get(operation) as f64;
    let dimension = D as i32;
    let of_points = points.len() as f64 * inverse.powi((dimension - 1) * (dimension - 1));
    let of_program = inverse.powi(2 * dimension * (dimension - 1));
    let read_by_programs = reads(Operation::EntryRead) + reads(Operation::GeneratorRead);
    Ok(Measurement::new(&counts, digest(&answer), verdict(&answer, epsilon))
        .with_value("net_size", Net::Paper.size(D, epsilon) as f64)
        .with_value("share_of_points", reads(Operation::ScanRead) / of_points)
        .with_value("share_of_program", read_by_programs / of_program))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_programs_along_the_net_read_points_and_entries() {
        let measured = measure(&Case::new(1, PLANE.id, "sphere_2", "papers_net", 4, 0)).expect("48 points");
        assert!(measured.counts["point_read"] >= 2 * 2 * POINTS as u64, "{:?}", measured.counts);
        assert!(measured.counts["entry_read"] > 0, "{:?}", measured.counts);
    }
}
