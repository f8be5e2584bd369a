//! Generators under a matrix, without a copy of them: directions and cells are pulled back into the frame in which
//! the generators are stored, and sums are pushed forward.
//!
//! Since u · M v = (Mᵀ u) · v, a pass over the images M v is a pass over the generators v with Mᵀ u in the place of
//! u. It is the same pass that bodies without a pose have. What the pose adds is a few roundings before and after the
//! pass, which widen the cell and the error bound of the sum.
//!
//! Let m be the sum of the magnitudes of all nine entries. No row and no column has a larger sum, so m bounds by how
//! much a coordinate grows, and every rounding error is a few u m. That is all that a single pass asks for. The sharper
//! bounds that a search needs take the determinant and two roots.

use super::direction_cone::DirectionCone;
use super::sign_pass::FixedSum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::linear::{SymmetricMatrix, cyclic_cross_products, dot, max_norm, sum_norm};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, SQUARABLE_SIZES, THIRTY_ROUNDINGS, UNDERFLOW, UNIT};
use crate::zonotope::pose::Pose;

/// The condition number, as size over least factor of a length, above which doubles have too few digits left for a
/// search.
const DISTORTION_LIMIT: f64 = 1e6;

/// The matrix of a pose, which is not the identity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame<'a> {
    pose: &'a Pose,
}

/// The factor by which a matrix makes lengths grow.
struct Growth {
    /// At least ‖M‖, the largest factor by which a length grows.
    norm: f64,
    /// At least the root of the sum of all squares of entries.
    size: f64,
}

impl<'a> Frame<'a> {
    /// The frame of a pose; none where its matrix is the identity, so that images are the generators themselves.
    #[inline]
    pub(crate) fn of(pose: &'a Pose) -> Option<Self> {
        (pose.rows() != Pose::IDENTITY.rows()).then_some(Self { pose })
    }

    /// Whether products with the entries that count neither overflow nor lose digits to underflow.
    #[inline(always)]
    pub(crate) fn is_moderate(&self) -> bool {
        self.pose.is_moderate()
    }

    /// M v, rounded: no coordinate is off by more than 4 u times that of |M| |v|.
    #[inline(always)]
    pub(crate) fn image(&self, v: &[f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.pose.rows();
        [dot(a, v), dot(b, v), dot(c, v)]
    }

    /// At least |M| x for the magnitudes of all entries and magnitudes x.
    #[inline(always)]
    pub(crate) fn image_of_sizes(&self, x: &[f64; 3]) -> [f64; 3] {
        self.pose.rows().map(|row| dot(&row.map(f64::abs), x) * FIVE_ROUNDINGS)
    }

    /// M v, rounded, with a bound of its length |M v|_1; that vector is off by at most 4 u times the bound.
    #[inline]
    pub(crate) fn image_with_length(&self, v: &[f64; 3]) -> ([f64; 3], f64) {
        // with room for what underflows in a product
        (self.image(v), self.pose.magnitude() * sum_norm(v) + SQUARABLE_SIZES.start)
    }

    /// M H Mᵀ, rounded.
    #[inline(always)]
    pub(crate) fn congruent(&self, &SymmetricMatrix([xx, xy, xz, yy, yz, zz]): &SymmetricMatrix) -> SymmetricMatrix {
        let [a, b, c] = self.pose.rows();
        let times = |row: &[f64; 3]| [dot(row, &[xx, xy, xz]), dot(row, &[xy, yy, yz]), dot(row, &[xz, yz, zz])];
        let [first, second, third] = [times(a), times(b), times(c)];
        let entries =
            [dot(&first, a), dot(&first, b), dot(&first, c), dot(&second, b), dot(&second, c), dot(&third, c)];
        SymmetricMatrix(entries)
    }

    /// At least Σ |M v|, and what takes its place in bounds of errors of sums over the images, from at least Σ |v|.
    ///
    /// A factor of two would do for the sums themselves: an error in the frame of the rows grows by at most the
    /// magnitude of M, and carrying a sum over is one more product. The other two are for directions, of which Mᵀ u is
    /// as long as the magnitude of M allows and rounded as well.
    #[inline(always)]
    pub(crate) fn carried_magnitude(&self, magnitude: f64) -> f64 {
        4.0 * self.pose.magnitude() * magnitude
    }

    /// Mᵀ u, rounded.
    #[inline(always)]
    pub(crate) fn pulled(&self, [x, y, z]: &[f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.pose.rows();
        [a[0] * x + b[0] * y + c[0] * z, a[1] * x + b[1] * y + c[1] * z, a[2] * x + b[2] * y + c[2] * z]
    }

    /// At least the sum of the magnitudes of the entries of M.
    #[inline]
    pub(crate) fn magnitude(&self) -> f64 {
        self.pose.magnitude()
    }

    /// No coordinate of the rounded Mᵀ u is off by more than 4 u times this number.
    #[inline]
    pub(crate) fn pulled_size(&self, u: &[f64; 3]) -> f64 {
        self.pose.magnitude() * max_norm(u) * FIVE_ROUNDINGS + UNDERFLOW
    }

    fn growth(&self) -> Growth {
        let m = self.pose.rows();
        let square = |i: usize, j: usize| (0..3).map(|k| m[k][i] * m[k][j]).sum::<f64>();
        let trace = square(0, 0) + square(1, 1) + square(2, 2);
        // ‖M‖² is at most the largest sum of magnitudes in a row of Mᵀ M, each of which is off by less than 4 u times
        // the trace
        let row = |i: usize| (0..3).map(|j| square(i, j).abs()).sum::<f64>();
        let norm = (row(0).max(row(1)).max(row(2)) + 16.0 * UNIT * trace).sqrt() * THIRTY_ROUNDINGS;
        Growth { norm, size: trace.sqrt() * THIRTY_ROUNDINGS }
    }

    /// The rounded image of any v is off by less than this part of |M v|; infinite where the matrix is singular or too
    /// nearly so.
    pub(crate) fn relative_error(&self) -> f64 {
        let Growth { norm, size } = self.growth();
        let [a, b, c] = self.pose.rows();
        let determinant = dot(a, &cyclic_cross_products(a, b, c)[0]);
        let least_determinant = determinant.abs() - 16.0 * UNIT * size * size * size;
        // the least factor of a length is the determinant over the two others; an image is off by less than 4 u ‖M‖ |v|
        let least = least_determinant / (norm * norm) * (1.0 - 8.0 * UNIT);
        let is_sound = least_determinant > 0.0 && size < DISTORTION_LIMIT * least && (1e-60..1e60).contains(&size);
        if is_sound { 8.0 * UNIT * size / least } else { f64::INFINITY }
    }

    /// At least |x|_1 / |M x|_1 for any x; infinite where the matrix is singular or too nearly so.
    pub(crate) fn shortening(&self) -> f64 {
        // √3 over the least factor of a length, with 2 in the place of √3 for the roundings
        2.0 * self.relative_error() / (8.0 * UNIT * self.growth().size)
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

    /// Mᵀ u for a direction that is known to twice the digits of a double.
    pub(crate) fn pair_pulled(&self, u: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        self.pose.transposed_pair_image(u)
    }

    /// A cell that holds Mᵀ u for all directions u of a cell.
    pub(crate) fn pulled_cell(&self, cell: &DirectionCone) -> DirectionCone {
        let Growth { norm, size } = self.growth();
        let total = sum_norm(&cell.center) + cell.axes.iter().flatten().map(sum_norm).sum::<f64>();
        // each coordinate of a product is off by less than 4 u ‖M‖ times the other factor
        let ball = (norm * cell.ball + 16.0 * UNIT * size * total) * FIVE_ROUNDINGS;
        let axes = cell.axes.map(|axes| axes.map(|axis| self.pulled(&axis)));
        DirectionCone { center: self.pulled(&cell.center), axes, ball }
    }

    /// The sum of the images of generators whose own sum is given.
    pub(crate) fn pushed_sum(&self, fixed: &FixedSum) -> FixedSum {
        let Growth { norm, size } = self.growth();
        let largest = max_norm(&fixed.sum);
        // a row's magnitudes sum up to less than twice ‖M‖
        let error = 2.0 * size * (fixed.error + 4.0 * UNIT * largest) * FIVE_ROUNDINGS;
        let magnitude = norm * fixed.magnitude * (1.0 + 4.0 * UNIT);
        FixedSum { sum: self.image(&fixed.sum), magnitude, error, read: fixed.read }
    }
}
