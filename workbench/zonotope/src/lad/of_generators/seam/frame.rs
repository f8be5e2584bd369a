//! Generators under a matrix, without a copy of them: directions and cells are pulled back into the frame in which
//! the generators are stored, and sums are pushed forward.
//!
//! Since u · M v = (Mᵀ u) · v, a pass over the images M v is a pass over the generators v with Mᵀ u in the place of
//! u. It is the same pass that bodies without a pose have. What the pose adds is a few roundings before and after the
//! pass, which widen the cell and the error bound of the sum.

use super::direction_cone::DirectionCone;
use super::linear_map::LinearMap;
use super::sign_pass::FixedSum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::linear::{max_norm, sum_norm};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, THIRTY_ROUNDINGS, UNIT};
use crate::zonotope::pose::Pose;

/// The condition number, as size over least factor of a length, above which doubles have too few digits left for a
/// search.
const DISTORTION_LIMIT: f64 = 1e6;

/// The matrix of a pose with the bounds that its passes need.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pose: Pose,
    /// The matrix is the identity, so that images are the generators themselves.
    is_identity: bool,
    /// At least ‖M‖, the largest factor by which a length grows.
    norm: f64,
    /// At least the root of the sum of all squares of entries.
    size: f64,
    /// The rounded image of any v is off by less than this part of |M v|; infinite where the matrix is singular or
    /// too nearly so.
    relative_error: f64,
}

impl Frame {
    pub(crate) fn new(pose: &Pose) -> Self {
        let m = pose.matrix();
        let square = |i: usize, j: usize| (0..3).map(|k| m[k][i] * m[k][j]).sum::<f64>();
        let slack = THIRTY_ROUNDINGS;
        let trace = square(0, 0) + square(1, 1) + square(2, 2);
        let size = trace.sqrt() * slack;
        // ‖M‖² is at most the largest sum of magnitudes in a row of Mᵀ M, each of which is off by less than 4 u times
        // the trace
        let row = |i: usize| (0..3).map(|j| square(i, j).abs()).sum::<f64>();
        let norm = (row(0).max(row(1)).max(row(2)) + 16.0 * UNIT * trace).sqrt() * slack;
        let [a, b, c] = m;
        let determinant = a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        let least_determinant = determinant.abs() - 16.0 * UNIT * size * size * size;
        // the least factor of a length is the determinant over the two others; an image is off by less than 4 u ‖M‖ |v|
        let least = least_determinant / (norm * norm) * (1.0 - 8.0 * UNIT);
        let is_sound = least_determinant > 0.0 && size < DISTORTION_LIMIT * least && (1e-60..1e60).contains(&size);
        let relative_error = if is_sound { 8.0 * UNIT * size / least } else { f64::INFINITY };
        let is_identity = m == Pose::IDENTITY.matrix();
        Self { pose: *pose, is_identity, norm, size, relative_error: if is_identity { 0.0 } else { relative_error } }
    }

    /// Whether images are the generators themselves.
    pub(crate) fn is_identity(&self) -> bool {
        self.is_identity
    }

    /// The rounded image of any v is off by less than this part of |M v|.
    pub(crate) fn relative_error(&self) -> f64 {
        self.relative_error
    }

    /// At least |x|_1 / |M x|_1 for any x; infinite where the matrix is singular or too nearly so.
    pub(crate) fn shortening(&self) -> f64 {
        // √3 over the least factor of a length, with 2 in the place of √3 for the roundings
        if self.is_identity { 1.0 } else { 2.0 * self.relative_error / (8.0 * UNIT * self.size) }
    }

    /// The matrix, for passes in doubles.
    #[inline]
    pub(crate) fn map(&self) -> LinearMap<'_> {
        LinearMap::of(&self.pose)
    }

    /// M v, exactly.
    pub(crate) fn exact_image(&self, v: &ExactVector) -> ExactVector {
        self.pose.exact_image(v)
    }

    /// M v for a vector that is known to twice the digits of a double.
    pub(crate) fn pair_image(&self, v: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        self.pose.pair_image(v)
    }

    /// Mᵀ u, exactly.
    pub(crate) fn exact_pulled(&self, u: &ExactVector) -> ExactVector {
        self.pose.exact_transposed_image(u)
    }

    /// A cell that holds Mᵀ u for all directions u of a cell.
    pub(crate) fn pulled_cell(&self, cell: &DirectionCone) -> DirectionCone {
        let total = sum_norm(&cell.center) + cell.axes.iter().flatten().map(sum_norm).sum::<f64>();
        // each coordinate of a product is off by less than 4 u ‖M‖ times the other factor
        let ball = (self.norm * cell.ball + 16.0 * UNIT * self.size * total) * FIVE_ROUNDINGS;
        let axes = cell.axes.map(|axes| axes.map(|axis| self.map().pulled(&axis)));
        DirectionCone { center: self.map().pulled(&cell.center), axes, ball }
    }

    /// The sum of the images of generators whose own sum is given.
    pub(crate) fn pushed_sum(&self, fixed: &FixedSum) -> FixedSum {
        let largest = max_norm(&fixed.sum);
        // a row's magnitudes sum up to less than twice ‖M‖
        let error = 2.0 * self.size * (fixed.error + 4.0 * UNIT * largest) * FIVE_ROUNDINGS;
        let magnitude = self.norm * fixed.magnitude * (1.0 + 4.0 * UNIT);
        FixedSum { sum: self.map().image(&fixed.sum), magnitude, error, read: fixed.read }
    }
}
