//! A small parallelogram around a guess.

use super::frame::Frame;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// The parallelogram { center + frame · z : |z_x|, |z_y| ≤ radius } with a lower triangular frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell {
    pub(crate) center: [f64; 2],
    pub(crate) radius: f64,
    pub(super) frame: Frame,
}

impl Cell {
    pub(crate) fn new(center: [f64; 2], radius: f64, frame: Frame) -> Self {
        Self { center, radius, frame }
    }

    /// The rectangle of given half-widths.
    pub(crate) fn upright(center: [f64; 2], [xx, yy]: [f64; 2]) -> Self {
        Self { center, radius: 1.0, frame: Frame { xx, yx: 0.0, yy } }
    }

    /// Whether a point, given within a relative 8 UNIT, certainly lies in the interior.
    pub(crate) fn contains(&self, point: [f64; 2]) -> bool {
        let [x, y] = self.coordinates(point);
        let [ex, ey] = self.coordinate_errors(point);
        x.abs() + ex < self.radius && y.abs() + ey < self.radius
    }

    /// The corners, counter-clockwise, rounded.
    pub(crate) fn corners(&self) -> [[f64; 2]; 4] {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|corner: [f64; 2]| {
            let [x, y] = corner.map(|c| c * self.radius);
            [self.center[0] + self.frame.xx * x, self.center[1] + self.frame.yx * x + self.frame.yy * y]
        })
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

    /// The cell of another radius around another point.
    pub(crate) fn moved(&self, center: [f64; 2], radius: f64) -> Self {
        Self { center, radius, ..*self }
    }
}
