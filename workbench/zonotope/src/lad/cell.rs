//! A small parallelogram around a guess: which lines certainly miss it, and on which side they leave it.

use super::instance::Instance;
use super::sides::read_sides;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::{Operation, Tally};

/// The parallelogram { center + frame · z : |z_x|, |z_y| ≤ radius } with a lower triangular frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell {
    pub(crate) center: [f64; 2],
    pub(crate) radius: f64,
    frame: Frame,
}

/// A lower triangular matrix [[xx, 0], [yx, yy]] that makes the normals of a set of lines about equally long in all
/// directions: the inverse transposed Cholesky factor of Σ normal normalᵀ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    xx: f64,
    yx: f64,
    yy: f64,
}

/// What a pass over the lines at a cell yields.
pub(crate) struct Split {
    /// The lines that may cross the cell.
    pub(crate) crossing: Vec<u32>,
    /// The sign of every other line throughout the cell; 0 for the crossing ones.
    pub(crate) signs: Vec<i8>,
    /// Σ sign · normal over the others, and how far each coordinate may be off.
    pub(crate) sum: [f64; 2],
    pub(crate) sum_error: f64,
}

impl Frame {
    /// The frame of the lines of an instance; `None` when it is not finite.
    pub(crate) fn of(instance: &Instance) -> Option<Self> {
        let columns = &*instance.columns;
        let normals = columns.normal_x.iter().zip(&columns.normal_y);
        let (xx, xy, yy) = normals.fold((0.0, 0.0, 0.0), |(xx, xy, yy), (x, y)| (xx + x * x, xy + x * y, yy + y * y));
        // Σ a aᵀ = C Cᵀ with C upper triangular, so that the frame (C⁻¹)ᵀ is lower triangular.
        let c_yy = yy.sqrt();
        let c_xy = xy / c_yy;
        let c_xx = (xx - c_xy * c_xy).sqrt();
        let frame = Self { xx: 1.0 / c_xx, yx: -c_xy / (c_xx * c_yy), yy: 1.0 / c_yy };
        [frame.xx, frame.yx, frame.yy].iter().all(|v| v.is_finite()).then_some(frame)
    }

    /// How far the value of a line with this normal changes over a cell of radius 1.
    pub(crate) fn reach(&self, x: f64, y: f64) -> f64 {
        (self.xx * x + self.yx * y).abs() + (self.yy * y).abs()
    }
}

impl Cell {
    pub(crate) fn new(center: [f64; 2], radius: f64, frame: Frame) -> Self {
        Self { center, radius, frame }
    }

    /// Whether a point, given within a relative 8 UNIT, certainly lies in the interior.
    pub(crate) fn contains(&self, point: [f64; 2]) -> bool {
        let [x, y] = self.coordinates(point);
        let [ex, ey] = self.coordinate_errors(point);
        x.abs() + ex < self.radius && y.abs() + ey < self.radius
    }

    fn coordinates(&self, point: [f64; 2]) -> [f64; 2] {
        let x = (point[0] - self.center[0]) / self.frame.xx;
        [x, (point[1] - self.center[1] - self.frame.yx * x) / self.frame.yy]
    }

    fn coordinate_errors(&self, point: [f64; 2]) -> [f64; 2] {
        let [dx, dy] = [0, 1].map(|i| 16.0 * UNIT * (point[i].abs() + self.center[i].abs()) + UNDERFLOW);
        let x = self.coordinates(point)[0].abs();
        let ex = dx / self.frame.xx + 16.0 * UNIT * x;
        [ex, (dy + self.frame.yx.abs() * (ex + 16.0 * UNIT * x)) / self.frame.yy]
    }

    /// The cell around the point nearest to `target` in the doubled cell, grown by a factor.
    pub(crate) fn moved_towards(&self, target: [f64; 2], growth: f64) -> Self {
        let [x, y] = self.coordinates(target).map(|v| v.clamp(-2.0 * self.radius, 2.0 * self.radius));
        let Frame { xx, yx, yy } = self.frame;
        let center = [self.center[0] + xx * x, self.center[1] + yx * x + yy * y];
        Self { center, radius: growth * self.radius, frame: self.frame }
    }

    /// Separates the lines that certainly miss the cell from the others. One pass.
    ///
    /// A line misses it when |value at the center| exceeds its reach; the margin covers the rounding of both and the
    /// error of the line's columns anywhere in the cell.
    pub(crate) fn split(&self, instance: &Instance, tally: &mut impl Tally) -> Split {
        tally.add(Operation::LineEvaluation, instance.len() as u64);
        let columns = &*instance.columns;
        let [cx, cy] = self.center;
        let Frame { xx, yx, yy } = self.frame;
        let [wx, wy] = [self.radius * xx, self.radius * (yx.abs() + yy)];
        let per_normal =
            |center: f64, width: f64| 16.0 * UNIT * (center.abs() + width) + instance.error.offset_per_normal;
        let (ex, ey) = (per_normal(cx, wx), per_normal(cy, wy));
        let eb = instance.error.offset_relative + 8.0 * UNIT;
        let floor = UNDERFLOW * (1.0 + cx.abs() + cy.abs() + wx + wy);
        let radius = self.radius;
        let (mut crossing, mut signs) = (Vec::new(), Vec::new());
        let sides = read_sides(
            columns,
            &mut signs,
            |x, y, b| {
                let reach = radius * ((xx * x + yx * y).abs() + (yy * y).abs());
                (x * cx + y * cy + b, reach + x.abs() * ex + y.abs() * ey + b.abs() * eb + floor)
            },
            |line| crossing.push(line as u32),
        );
        Split { crossing, signs, sum: sides.sum, sum_error: sides.sum_error }
    }
}
