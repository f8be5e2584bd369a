//! The linear part of a pose in doubles: images of generators, directions pulled back into the frame of the rows, and
//! what both may be off by.
//!
//! Let m be the sum of the magnitudes of all nine entries. No row and no column has a larger sum, so m bounds by how
//! much a coordinate grows, and every rounding error is a few u m. The determinant is not asked for: [`Frame`] has the
//! sharper bounds that a search needs, at a higher cost.
//!
//! [`Frame`]: crate::lad::of_generators::seam::frame::Frame

use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::linear::{dot, max_norm, sum_norm};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, MATRIX_SIZES, SQUARABLE_SIZES, UNDERFLOW, UNIT};
use crate::zonotope::pose::Pose;

/// A matrix by rows, and at least the sum of the magnitudes of its entries.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LinearMap<'a> {
    rows: &'a [[f64; 3]; 3],
    pub(crate) magnitude: f64,
}

impl<'a> LinearMap<'a> {
    #[inline(always)]
    pub(crate) fn of(pose: &'a Pose) -> Self {
        let rows = pose.rows();
        let magnitude = (sum_norm(&rows[0]) + sum_norm(&rows[1]) + sum_norm(&rows[2])) * FIVE_ROUNDINGS;
        Self { rows, magnitude }
    }

    /// Whether products with the entries that count neither overflow nor lose digits to underflow.
    #[inline(always)]
    pub(crate) fn is_moderate(&self) -> bool {
        MATRIX_SIZES.contains(&self.magnitude)
    }

    /// M v, rounded: no coordinate is off by more than 4 u times the magnitude of M and that of v.
    #[inline(always)]
    pub(crate) fn image(&self, v: &[f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.rows;
        [dot(a, v), dot(b, v), dot(c, v)]
    }

    /// M v, rounded, with a bound of each coordinate's error.
    #[inline]
    pub(crate) fn bounded_image(&self, v: &[f64; 3]) -> BoundedVector {
        // with room for what underflows in a product
        let error = 4.0 * UNIT * (self.magnitude * sum_norm(v) + SQUARABLE_SIZES.start) * FIVE_ROUNDINGS;
        self.image(v).map(|value| Bounded { value, error })
    }

    /// M H Mᵀ, rounded; a symmetric matrix is given by xx, xy, xz, yy, yz, zz.
    #[inline(always)]
    pub(crate) fn congruent(&self, &[xx, xy, xz, yy, yz, zz]: &[f64; 6]) -> [f64; 6] {
        let [a, b, c] = self.rows;
        let times = |row: &[f64; 3]| [dot(row, &[xx, xy, xz]), dot(row, &[xy, yy, yz]), dot(row, &[xz, yz, zz])];
        let [first, second, third] = [times(a), times(b), times(c)];
        [dot(&first, a), dot(&first, b), dot(&first, c), dot(&second, b), dot(&second, c), dot(&third, c)]
    }

    /// At least Σ |M v|, and what takes its place in bounds of errors of sums over the images, from at least Σ |v|.
    ///
    /// A factor of two would do for the sums themselves: an error in the frame of the rows grows by at most the
    /// magnitude of M, and carrying a sum over is one more product. The other two are for directions, of which Mᵀ u is
    /// as long as the magnitude of M allows and rounded as well.
    #[inline(always)]
    pub(crate) fn carried_magnitude(&self, magnitude: f64) -> f64 {
        4.0 * self.magnitude * magnitude
    }

    /// Mᵀ u, rounded.
    #[inline(always)]
    pub(crate) fn pulled(&self, [x, y, z]: &[f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.rows;
        [a[0] * x + b[0] * y + c[0] * z, a[1] * x + b[1] * y + c[1] * z, a[2] * x + b[2] * y + c[2] * z]
    }

    /// No coordinate of the rounded Mᵀ u is off by more than 4 u times this number.
    #[inline]
    pub(crate) fn pulled_size(&self, u: &[f64; 3]) -> f64 {
        self.magnitude * max_norm(u) * FIVE_ROUNDINGS + UNDERFLOW
    }
}
