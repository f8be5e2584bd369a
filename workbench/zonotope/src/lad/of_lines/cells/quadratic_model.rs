//! A quadratic model of the objective in a cell, and the smaller cell around the minimum of the model.

use super::cell::Cell;
use super::frame::Frame;

/// Share of the cell's radius that the smaller cell has at least, since lines are not spread evenly over the cell.
const SMALLEST_SHARE: f64 = 0.05;

/// Share of the cell's radius that the smaller cell gains per square of the distance of its centre, in radii.
const SHARE_PER_SQUARED_DISTANCE: f64 = 0.5;

/// Standard deviations of the gradient at the minimum of the model that the lines crossing the smaller cell can make up
/// for.
const GRADIENT_DEVIATIONS: f64 = 3.0;

/// Distances, in radii, between which the model's error is taken to grow like the distance.
const ERROR_GROWTH_RANGE: [f64; 2] = [0.125, 1.0];

/// Radii by which one Newton step moves the centre at most along each axis of the frame.
const LONGEST_STEP: f64 = 3.0;

/// Share of the cell's radius that the smaller cell has at most.
const LARGEST_SHARE: f64 = 2.0;

/// The gradient and the curvature that the lines crossing a cell give the objective in it, in the coordinates of the
/// frame.
#[derive(Debug, Default, Clone, Copy)]
pub(crate) struct QuadraticModel {
    /// The sum Σ sign · normal at the centre.
    gradient: [f64; 2],
    /// The entries xx, xy, yy of Σ normal normalᵀ / reach.
    hessian: [f64; 3],
    /// The sum Σ reach.
    reach: f64,
    /// The sum Σ reach².
    squares: f64,
}

impl QuadraticModel {
    /// Adds a crossing line with this normal and this value at the centre.
    pub(super) fn add(&mut self, frame: Frame, [x, y]: [f64; 2], value: f64) {
        let [u, v] = frame.turned(x, y);
        let reach = u.abs() + v.abs();
        if reach > 0.0 {
            let sign = if value == 0.0 { 0.0 } else { value.signum() };
            self.gradient[0] += sign * u;
            self.gradient[1] += sign * v;
            self.hessian[0] += u * u / reach;
            self.hessian[1] += u * v / reach;
            self.hessian[2] += v * v / reach;
            self.reach += reach;
            self.squares += reach * reach;
        }
    }
}

impl Cell {
    /// A smaller cell around the minimum of the model, and the distance of that point in radii of this cell.
    ///
    /// `rest` is the gradient of all terms that do not cross the cell. Spread evenly, a crossing line curves the
    /// objective by normal normalᵀ / (reach · radius) on average, which gives a Newton step from the centre. The
    /// gradient at its end is off by the lines that chance put between the centre and there, a share of all lines that
    /// grows with the distance.
    pub(crate) fn expected(&self, rest: [f64; 2], model: &QuadraticModel) -> Option<(Self, f64)> {
        let [u, v] = self.frame.turned(rest[0], rest[1]);
        let [u, v] = [u + model.gradient[0], v + model.gradient[1]];
        let [xx, xy, yy] = model.hessian;
        let determinant = xx * yy - xy * xy;
        let step = [(xy * v - yy * u) / determinant, (xy * u - xx * v) / determinant];
        let distance = step[0].abs().max(step[1].abs());
        let [shortest, longest] = ERROR_GROWTH_RANGE;
        let deviation = (model.squares * distance.clamp(shortest, longest)).sqrt();
        let gathered = GRADIENT_DEVIATIONS * deviation / model.reach;
        let share = gathered + SMALLEST_SHARE + SHARE_PER_SQUARED_DISTANCE * distance * distance;
        let [x, y] = step.map(|v| self.radius * v.clamp(-LONGEST_STEP, LONGEST_STEP));
        let Frame { xx, yx, yy } = self.frame;
        let center = [self.center[0] + xx * x, self.center[1] + yx * x + yy * y];
        let radius = self.radius * share.min(LARGEST_SHARE);
        let is_usable = distance.is_finite() && center.iter().all(|v| v.is_finite()) && radius > 0.0;
        is_usable.then(|| (self.moved(center, radius), distance))
    }
}
