//! A small parallelogram around a guess: which lines certainly miss it, and on which side they leave it.

use super::subproblem::instance::{Instance, Rows};
use super::subproblem::sides::read_sides;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::Tally;

/// A cell around an expected point has this share of the larger cell's radius at least, and this much more of it times the square of
/// the distance, in radii, of the point: the lines are not spread evenly.
const UNEVENNESS: [f64; 2] = [0.05, 0.5];

/// The lines that cross a cell around an expected point can make up for so many standard deviations of the gradient there.
const DEVIATIONS: f64 = 3.0;

/// There is room for one line in so many to cross a cell before more must be made.
const FEW: usize = 4;

/// The parallelogram { center + frame · z : |z_x|, |z_y| ≤ radius } with a lower triangular frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell {
    pub(crate) center: [f64; 2],
    pub(crate) radius: f64,
    pub(crate) frame: Frame,
}

/// A lower triangular matrix [[xx, 0], [yx, yy]] that makes the normals of a set of lines about equally long in all
/// directions: the inverse transposed Cholesky factor of Σ normal normalᵀ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    xx: f64,
    yx: f64,
    yy: f64,
}

/// What the lines that cross a cell say about the objective in it, in the coordinates of the frame.
#[derive(Debug, Default, Clone, Copy)]
pub(crate) struct Bend {
    /// Σ sign · normal at the centre.
    gradient: [f64; 2],
    /// xx, xy, yy of Σ normal normalᵀ / reach.
    hessian: [f64; 3],
    /// Σ reach.
    reach: f64,
    /// Σ reach².
    squares: f64,
}

/// What a pass over the lines at a cell yields.
pub(crate) struct Split {
    /// The lines that may cross the cell.
    pub(crate) crossing: Vec<u32>,
    /// Their rows.
    pub(crate) rows: Rows,
    /// The sign of every other line throughout the cell; 0 for the crossing ones.
    pub(crate) signs: Vec<i8>,
    /// Σ sign · normal over the others, and how far each coordinate may be off.
    pub(crate) sum: [f64; 2],
    pub(crate) sum_error: f64,
    /// How the crossing lines bend the objective.
    pub(crate) bend: Bend,
}

impl Bend {
    /// Adds a line with this value at the centre.
    pub(crate) fn add(&mut self, frame: Frame, [x, y]: [f64; 2], value: f64) {
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

impl Frame {
    /// The frame of the lines of an instance; `None` when it is not finite.
    pub(crate) fn of(instance: &Instance) -> Option<Self> {
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        instance.lines.each_block(|_, block| {
            for (x, y) in block.normal_x.iter().zip(block.normal_y) {
                (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
            }
        });
        // Σ a aᵀ = C Cᵀ with C upper triangular, so that the frame (C⁻¹)ᵀ is lower triangular.
        let c_yy = yy.sqrt();
        let c_xy = xy / c_yy;
        let c_xx = (xx - c_xy * c_xy).sqrt();
        let frame = Self { xx: 1.0 / c_xx, yx: -c_xy / (c_xx * c_yy), yy: 1.0 / c_yy };
        [frame.xx, frame.yx, frame.yy].iter().all(|v| v.is_finite()).then_some(frame)
    }

    /// How far the value of a line with this normal changes over a cell of radius 1.
    pub(crate) fn reach(&self, x: f64, y: f64) -> f64 {
        let [u, v] = self.turned(x, y);
        u.abs() + v.abs()
    }

    /// The gradient of a linear function in the coordinates of the frame.
    fn turned(&self, x: f64, y: f64) -> [f64; 2] {
        [self.xx * x + self.yx * y, self.yy * y]
    }
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

    /// The cell of another size around another point.
    pub(crate) fn moved(&self, center: [f64; 2], radius: f64) -> Self {
        Self { center, radius, ..*self }
    }

    /// A cell around the point where the gradient is expected to vanish, and the distance of that point in radii of this cell.
    ///
    /// `rest` is the gradient of all that does not cross the cell. Spread evenly, a crossing line bends the objective by
    /// normal normalᵀ / (reach · radius) on average: that gives a Newton step from the centre. The gradient where it ends is off by the
    /// lines that luck put between the centre and there, a share of all that grows with the distance.
    pub(crate) fn expected(&self, rest: [f64; 2], bend: &Bend) -> Option<(Self, f64)> {
        let [u, v] = self.frame.turned(rest[0], rest[1]);
        let [u, v] = [u + bend.gradient[0], v + bend.gradient[1]];
        let [xx, xy, yy] = bend.hessian;
        let determinant = xx * yy - xy * xy;
        let step = [(xy * v - yy * u) / determinant, (xy * u - xx * v) / determinant];
        let distance = step[0].abs().max(step[1].abs());
        let deviation = (bend.squares * distance.clamp(0.125, 1.0)).sqrt();
        let share = DEVIATIONS * deviation / bend.reach + UNEVENNESS[0] + UNEVENNESS[1] * distance * distance;
        let [x, y] = step.map(|v| self.radius * v.clamp(-3.0, 3.0));
        let Frame { xx, yx, yy } = self.frame;
        let center = [self.center[0] + xx * x, self.center[1] + yx * x + yy * y];
        let radius = self.radius * share.min(2.0);
        let is_usable = distance.is_finite() && center.iter().all(|v| v.is_finite()) && radius > 0.0;
        is_usable.then(|| (self.moved(center, radius), distance))
    }

    /// Separates the lines that certainly miss the cell from the others. One pass.
    ///
    /// A line misses it when |value at the center| exceeds its reach; the margin covers the rounding of both and the
    /// error of the line's columns anywhere in the cell.
    pub(crate) fn split(&self, instance: &Instance, tally: &mut impl Tally) -> Split {
        instance.count_pass(tally);
        let [cx, cy] = self.center;
        let Frame { xx, yx, yy } = self.frame;
        let [wx, wy] = [self.radius * xx, self.radius * (yx.abs() + yy)];
        let floor = UNDERFLOW * (1.0 + cx.abs() + cy.abs() + wx + wy);
        let radius = self.radius;
        let few = instance.len() / FEW;
        let (mut crossing, mut rows, mut signs) = (Vec::with_capacity(few), Rows::with_capacity(few), Vec::new());
        let mut bend = Bend::default();
        let sides = read_sides(
            &instance.lines,
            &mut signs,
            |error| {
                let per_normal =
                    |center: f64, width: f64| 16.0 * UNIT * (center.abs() + width) + error.offset_per_normal;
                let (ex, ey, eb) = (per_normal(cx, wx), per_normal(cy, wy), error.offset_relative + 8.0 * UNIT);
                move |x, y, b| {
                    let reach = radius * ((xx * x + yx * y).abs() + (yy * y).abs());
                    (x * cx + y * cy + b, reach + x.abs() * ex + y.abs() * ey + b.abs() * eb + floor)
                }
            },
            |line, [x, y, b], error| {
                crossing.push(line as u32);
                rows.push([x, y, b], error);
                bend.add(self.frame, [x, y], x * cx + y * cy + b);
                0
            },
        );
        Split { crossing, rows, signs, sum: sides.sum, sum_error: sides.sum_error, bend }
    }
}
