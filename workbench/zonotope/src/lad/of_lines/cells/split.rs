//! The lines that certainly miss a cell, and those that may cross it.

use super::cell::Cell;
use super::frame::Frame;
use super::quadratic_model::QuadraticModel;
use crate::lad::of_lines::input::rounded_lines::GatheredLines;
use crate::lad::of_lines::subproblem::Subproblem;
use crate::lad::of_lines::subproblem::sign_pass::{Reading, read_sides};
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::Tally;

/// Number of lines per crossing line for which there is room before the pass must ask for memory.
const LINES_PER_EXPECTED_CROSSING: usize = 4;

/// The yield of one pass over the lines at a cell.
pub(crate) struct Split {
    /// The lines that may cross the cell.
    pub(crate) crossing: Vec<u32>,
    /// The coefficients of the crossing lines.
    pub(crate) rows: GatheredLines,
    /// The sign of every other line throughout the cell; 0 for the crossing ones.
    pub(crate) signs: Vec<i8>,
    /// The rounded sum Σ sign · normal over the other lines.
    pub(crate) sum: [f64; 2],
    /// A bound on the error of each coordinate of the sum.
    pub(crate) sum_error: f64,
    /// The model of the objective that the crossing lines make in the cell.
    pub(crate) model: QuadraticModel,
}

impl Split {
    /// Whether the objective certainly changes over a cell that no line crosses, where it is linear.
    pub(crate) fn is_certainly_slanted(&self, subproblem: &Subproblem) -> bool {
        let error = 2.0 * (self.sum_error + subproblem.linear_error);
        (0..2).any(|axis| (self.sum[axis] + subproblem.linear[axis]).abs() > error)
    }
}

impl Cell {
    /// Separates the lines that certainly miss the cell from the others. One pass.
    ///
    /// A line misses the cell when |value at the centre| exceeds its reach; the margin covers the rounding of both and
    /// the error of the line's columns anywhere in the cell.
    pub(crate) fn split(&self, subproblem: &Subproblem, tally: &mut impl Tally) -> Split {
        subproblem.count_pass(tally);
        let [cx, cy] = self.center;
        let Frame { xx, yx, yy } = self.frame;
        let [wx, wy] = [self.radius * xx, self.radius * (yx.abs() + yy)];
        let floor = UNDERFLOW * (1.0 + cx.abs() + cy.abs() + wx + wy);
        let radius = self.radius;
        let room = subproblem.len() / LINES_PER_EXPECTED_CROSSING;
        let (mut crossing, mut rows) = (Vec::with_capacity(room), GatheredLines::with_capacity(room));
        let mut signs = Vec::new();
        let mut model = QuadraticModel::default();
        let sides = read_sides(
            &subproblem.lines,
            &mut signs,
            |error| {
                let per_normal =
                    |center: f64, width: f64| 16.0 * UNIT * (center.abs() + width) + error.offset_per_normal;
                Reading {
                    point: [cx, cy],
                    across: [radius * xx, radius * yx],
                    per_x: per_normal(cx, wx),
                    per_y: per_normal(cy, wy) + radius * yy.abs(),
                    per_offset: error.offset_relative + 8.0 * UNIT,
                    floor,
                }
            },
            |line, [x, y, b], error| {
                crossing.push(line as u32);
                rows.push([x, y, b], error);
                model.add(self.frame, [x, y], x * cx + y * cy + b);
                0
            },
        );
        Split { crossing, rows, signs, sum: sides.sum, sum_error: sides.sum_error, model }
    }
}
