//! A point on one side of all lines of a balanced problem: without a linear term, and with normals that sum to zero.
//!
//! The sum of all values is the same everywhere, and the objective is not below its magnitude. So a cell on one side of
//! all lines is a set of minimisers, and what is left to find is a vertex on its boundary. Such a cell is far smaller
//! than the distances between the lines' common points, and a descent along its boundary visits many of them.

use crate::lad::of_lines::cells::{Cell, Frame};
use crate::lad::of_lines::subproblem::Subproblem;
use crate::tally::Tally;

/// Share of the least distance of a line of a sample that the cell's radius is.
const RADIUS_SHARE: f64 = 0.25;

/// A line on the boundary of a cell of minimisers, where a point expected to be on one side of all lines is so.
/// One pass over the sample, and two over all lines if the sample does not contradict.
pub(super) fn boundary_line(subproblem: &Subproblem, sample: &Subproblem, tally: &mut impl Tally) -> Option<u32> {
    let center = subproblem.balanced_center()?;
    let cell = cell_beside(sample, center, tally)?;
    let split = cell.split(subproblem, tally);
    let is_one_side = split.crossing.is_empty() && !split.is_certainly_slanted(subproblem);
    if is_one_side { subproblem.nearest_line(center, tally) } else { None }
}

/// A cell around a point that is on one side of all lines of a sample and misses them.
fn cell_beside(sample: &Subproblem, center: [f64; 2], tally: &mut impl Tally) -> Option<Cell> {
    sample.count_pass(tally);
    let frame = Frame::of(sample)?;
    let mut distances = [f64::INFINITY, f64::NEG_INFINITY];
    sample.lines.each_block(|_, block| {
        for line in 0..block.len() {
            let [x, y, b] = block.row(line);
            let distance = (x * center[0] + y * center[1] + b) / frame.reach(x, y);
            distances = [distances[0].min(distance), distances[1].max(distance)];
        }
    });
    let [least, largest] = distances;
    let distance = if least > 0.0 { least } else { -largest };
    let radius = RADIUS_SHARE * distance;
    (radius > 0.0 && radius.is_finite()).then(|| Cell::new(center, radius, frame))
}
