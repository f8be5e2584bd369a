//! The reads of Theorem 4.7, against the number of points.

use super::fixed_directions_methods::{digest, solve};
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use families::clouds::Cloud;
use zonotope::enclosing::fixed_directions::FixedDirections;
use zonotope::enclosing::min_total_length::direction_net::cell_middles;
use zonotope::interop::verifier::check_min_length_dirs_bounds;
use zonotope::tally::OperationCounts;

/// Cells along a side of the square with which the paper's net of the plane is one for epsilon = 3/32.
const CELLS: usize = 22;

const FAMILIES: &[&str] = &["ball_2", "sphere_2"];

/// The reads of Theorem 4.7, against the number of points.
pub const EXPERIMENT: Experiment = Experiment {
    id: "net-points",
    title: "Least total length along the paper's net: growth with the number of points",
    question: "How many points does Theorem 4.7 read, against their number? The paper's program is solved along the \
               paper's net of the plane for epsilon = 3/32, which has 46 directions. `scan_read` counts what the \
               paper's scan reads, each point once for each normal, and `point_read` what our own proof of containment \
               reads.",
    claims: &["theorem-4.7"],
    families: FAMILIES,
    sizes: super::LINEAR_SIZES,
    instances: PerProfile::both(3),
    variants: &[Variant::at_all_sizes("papers_net", "The paper's net")],
    refuses: |points| match points {
        Cloud::Plane(_) => None,
        Cloud::Space(_) | Cloud::Four(_) => Some("only points of the plane are enclosed"),
    },
    measure,
    fits: &[FitPlan::of_operations("papers_net", FAMILIES)
        .of(Quantity::Count("scan_read"))
        .within(Bound::of_paper(GrowthModel::Linear, "Theorem 4.7"))
        .at_least(GrowthModel::Linear)],
    ..Experiment::COUNTED
};

/// The directions of the paper's net of the plane: the middles of so many cells along a side, and the axes.
fn net(cells: usize) -> Vec<[f64; 2]> {
    let mut net = cell_middles::<2>(cells);
    for axis in [[1.0, 0.0], [0.0, 1.0]] {
        if !net.contains(&axis) {
            net.push(axis);
        }
    }
    net
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let Cloud::Plane(points) = case.cloud()? else { return Err("only points of the plane are enclosed".to_owned()) };
    along_net(&points, CELLS)
}

/// The paper's program along the paper's net of so many cells along a side.
pub(super) fn along_net(points: &[[f64; 2]], cells: usize) -> Result<Measurement, String> {
    let directions = net(cells);
    let weights = vec![1.0; directions.len()];
    let problem = FixedDirections::new(points, &directions, &weights).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    let answer = solve("papers_program", &problem, &mut counts)?;
    let verdict = Verdict::of_verifier("check_min_length_dirs_bounds", check_min_length_dirs_bounds(&problem, &answer));
    Ok(Measurement::new(&counts, digest(&answer), verdict)
        .with_value("directions", directions.len() as f64)
        .with_value("relative_gap", answer.relative_gap()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use zonotope::enclosing::min_total_length::Net;

    #[test]
    fn the_directions_are_the_net_for_three_of_32() {
        let size = Net::Paper.size(2, 3.0 / 32.0);
        assert!(net(CELLS).len() == 46 && net(CELLS).len() <= size && size == 2 * CELLS + 2);
    }
}
