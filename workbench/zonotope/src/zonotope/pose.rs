//! Poses: where a body of space stands, as a matrix and a translation that are taken as the exact numbers that they
//! are.
//!
//! A pose maps x to M x + t. Decisions about posed bodies are exact for the pose as it is given, so a matrix of doubles
//! that is a rotation but for rounding makes a body that is congruent to the original one but for rounding, and
//! [`Pose::distance_from_rotation`] says how nearly.

use std::fmt;

use thiserror::Error;

use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, dot, exact};
use crate::numeric::linear::sum_norm;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, MATRIX_SIZES};

/// A pose of space: x ↦ M x + t.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    matrix: [[f64; 3]; 3],
    translation: [f64; 3],
}

/// Why numbers are no pose.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum PoseError {
    /// An entry of the matrix or a coordinate of the translation is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// An axis or a quaternion has no direction: it is zero or not finite, or an angle is not finite.
    #[error("the rotation has no axis or angle: {value:?} cannot be scaled to length 1")]
    NoRotation {
        /// The numbers that were given: an axis with its angle, or a quaternion.
        value: [f64; 4],
    },
}

impl Pose {
    /// The pose that moves nothing.
    pub const IDENTITY: Self =
        Self { matrix: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], translation: [0.0; 3] };

    /// The pose x ↦ M x + t, the matrix by rows. Any matrix is a pose: one that mirrors, scales or flattens as well.
    ///
    /// # Errors
    /// [`PoseError`] names the first entry that is not finite.
    #[inline]
    pub fn new(matrix: [[f64; 3]; 3], translation: [f64; 3]) -> Result<Self, PoseError> {
        NonFinite::check_matrix(&matrix)?;
        NonFinite::check_vector("the translation", &translation)?;
        Ok(Self { matrix, translation })
    }

    /// The pose that only translates.
    ///
    /// # Errors
    /// [`PoseError::NonFinite`] if a coordinate is not finite.
    pub fn from_translation(translation: [f64; 3]) -> Result<Self, PoseError> {
        Self::new(Self::IDENTITY.matrix, translation)
    }

    /// The rotation about an axis through the origin by an angle in radians, then a translation. The axis may have any
    /// length but zero.
    ///
    /// The matrix is a rotation within 2^-50 in every entry; it is the exact pose of the body all the same.
    ///
    /// # Errors
    /// [`PoseError`] if the axis has no direction, or a number is not finite.
    pub fn from_axis_angle(axis: [f64; 3], radians: f64, translation: [f64; 3]) -> Result<Self, PoseError> {
        let [x, y, z] = axis;
        let (sin, cos) = (libm::sin(radians / 2.0), libm::cos(radians / 2.0));
        let none = PoseError::NoRotation { value: [x, y, z, radians] };
        let [x, y, z] = normalized(axis).ok_or(none)?;
        if !radians.is_finite() {
            return Err(none);
        }
        Self::from_quaternion([cos, sin * x, sin * y, sin * z], translation)
    }

    /// The rotation of a quaternion w + x i + y j + z k of any length but zero, given as [w, x, y, z], then a
    /// translation.
    ///
    /// The matrix is a rotation within 2^-50 in every entry; it is the exact pose of the body all the same.
    ///
    /// # Errors
    /// [`PoseError`] if the quaternion is zero, or a number is not finite.
    pub fn from_quaternion(quaternion: [f64; 4], translation: [f64; 3]) -> Result<Self, PoseError> {
        let [w, x, y, z] = normalized(quaternion).ok_or(PoseError::NoRotation { value: quaternion })?;
        // of a quaternion of any length s the entries are these over s; the length differs from 1 by rounding
        let scale = 2.0 / (w * w + x * x + y * y + z * z);
        let [ww, xx, yy, zz] = [w * w, x * x, y * y, z * z].map(|c| scale * c);
        let [xy, xz, yz] = [x * y, x * z, y * z].map(|c| scale * c);
        let [wx, wy, wz] = [w * x, w * y, w * z].map(|c| scale * c);
        let matrix = [
            [(ww + xx) - 1.0, xy - wz, xz + wy],
            [xy + wz, (ww + yy) - 1.0, yz - wx],
            [xz - wy, yz + wx, (ww + zz) - 1.0],
        ];
        Self::new(matrix, translation)
    }

    /// The matrix, by rows.
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        self.matrix
    }

    /// The matrix, by rows, without a copy.
    #[inline]
    pub(crate) fn rows(&self) -> &[[f64; 3]; 3] {
        &self.matrix
    }

    /// At least the sum of the magnitudes of the matrix's entries.
    #[inline(always)]
    pub(crate) fn magnitude(&self) -> f64 {
        let [a, b, c] = &self.matrix;
        (sum_norm(a) + sum_norm(b) + sum_norm(c)) * FIVE_ROUNDINGS
    }

    /// Whether products with the entries that count neither overflow nor lose digits to underflow.
    #[inline(always)]
    pub(crate) fn is_moderate(&self) -> bool {
        MATRIX_SIZES.contains(&self.magnitude())
    }

    /// The translation.
    pub fn translation(&self) -> [f64; 3] {
        self.translation
    }

    /// The largest entry of Mᵀ M − I in magnitude, within a few roundings: 0 for a rotation or a reflection, and about
    /// how far lengths and angles of a posed body are off those of the body itself.
    pub fn distance_from_rotation(&self) -> f64 {
        let [a, b, c] = &self.matrix;
        let product = |i: usize, j: usize| a[i] * a[j] + b[i] * b[j] + c[i] * c[j];
        let [x, y, z] = [0, 1, 2].map(|i| (product(i, i) - 1.0).abs());
        let [u, v, w] = [product(0, 1), product(0, 2), product(1, 2)].map(f64::abs);
        x.max(y).max(z).max(u).max(v.max(w))
    }

    /// M v, exactly.
    pub(crate) fn exact_image(&self, v: &ExactVector) -> ExactVector {
        self.matrix.map(|row| dot(&exact(row), v))
    }

    /// Mᵀ u, exactly.
    pub(crate) fn exact_transposed_image(&self, u: &ExactVector) -> ExactVector {
        [0, 1, 2].map(|k| dot(&exact(self.matrix.map(|row| row[k])), u))
    }

    /// The image of a vector that is known to twice the digits of a double.
    pub(crate) fn pair_image(&self, [x, y, z]: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        let of = BoundedDoubleDouble::exact;
        self.matrix.map(|[a, b, c]| of(a) * *x + of(b) * *y + of(c) * *z)
    }

    /// Mᵀ u for a direction that is known to twice the digits of a double.
    pub(crate) fn transposed_pair_image(&self, [x, y, z]: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        let of = BoundedDoubleDouble::exact;
        let [a, b, c] = self.matrix.map(|row| row.map(of));
        [0, 1, 2].map(|k| a[k] * *x + b[k] * *y + c[k] * *z)
    }

    /// M x + t, rounded; with each coordinate the sum of the magnitudes of what it is the sum of.
    #[inline(always)]
    pub(crate) fn rounded_point(&self, x: &[f64; 3]) -> [(f64, f64); 3] {
        let coordinate = |row: &[f64; 3], t: f64| {
            let [a, b, c] = [row[0] * x[0], row[1] * x[1], row[2] * x[2]];
            (a + b + c + t, a.abs() + b.abs() + c.abs() + t.abs())
        };
        let ([a, b, c], [r, s, t]) = (&self.matrix, self.translation);
        [coordinate(a, r), coordinate(b, s), coordinate(c, t)]
    }

    /// M x + t, exactly.
    pub(crate) fn exact_point(&self, x: [f64; 3]) -> ExactVector {
        let [a, b, c] = self.exact_image(&exact(x));
        let [x, y, z] = self.translation.map(Dyadic::from_f64);
        [a + x, b + y, c + z]
    }
}

impl Default for Pose {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// The place of a body: as it is stored ([`AtRest`]), or as a [`Pose`] puts it. A type parameter with two values, so
/// that the same code serves bodies under poses and bodies as they are stored, and these pay nothing for the
/// possibility of a pose.
pub trait Standing: Copy + Default + fmt::Debug + PartialEq + Send + Sync + sealed::Sealed {
    /// Whether no value of the type is a pose.
    const IS_FIXED: bool;

    /// The pose, if there is one.
    fn pose(&self) -> Option<&Pose>;

    /// The same with another translation, if there is a pose; every coordinate is finite.
    #[doc(hidden)]
    fn with_translation(self, translation: [f64; 3]) -> Self;
}

mod sealed {
    /// No type outside of the library says where a body stands.
    pub trait Sealed {}

    impl Sealed for super::AtRest {}

    impl Sealed for super::Pose {}
}

/// The standing of a body that is taken as it is stored.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct AtRest;

impl Standing for AtRest {
    const IS_FIXED: bool = true;

    #[inline(always)]
    fn pose(&self) -> Option<&Pose> {
        None
    }

    fn with_translation(self, _: [f64; 3]) -> Self {
        self
    }
}

impl Standing for Pose {
    const IS_FIXED: bool = false;

    #[inline(always)]
    fn pose(&self) -> Option<&Pose> {
        Some(self)
    }

    fn with_translation(self, translation: [f64; 3]) -> Self {
        Self { translation, ..self }
    }
}

/// The numbers over the root of the sum of their squares, whatever their size; none if that is zero or not finite.
fn normalized<const N: usize>(numbers: [f64; N]) -> Option<[f64; N]> {
    let largest = numbers.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    if !(largest > 0.0 && numbers.iter().all(|c| c.is_finite())) {
        return None;
    }
    // twice: the first quotient of the least doubles loses digits, the second one has them all
    let scaled = numbers.map(|c| c / largest);
    let length = scaled.iter().map(|c| c * c).sum::<f64>().sqrt();
    Some(scaled.map(|c| c / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_worked_out_by_hand() {
        let pose =
            Pose::from_axis_angle([0.0, 0.0, 3.0], std::f64::consts::FRAC_PI_2, [1.0, 0.0, 0.0]).expect("an axis");
        let image = pose.exact_point([2.0, 0.0, 5.0]).map(|c| c.to_f64());
        let expected = [1.0, 2.0, 5.0];
        assert!(image.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{image:?}");
        assert!(pose.distance_from_rotation() < 1e-15);
    }

    #[test]
    fn rotations_are_rotations_within_the_stated_distance() {
        for quaternion in
            [[1.0, 2.0, 3.0, 4.0], [1e-300, 0.0, -1e-300, 0.0], [1e300, 1e300, 1e300, -1e300], [0.0, 0.0, 0.0, 5e-324]]
        {
            let pose = Pose::from_quaternion(quaternion, [0.0; 3]).expect("a quaternion");
            assert!(pose.distance_from_rotation() < 4.0 * f64::EPSILON, "{quaternion:?}");
        }
    }

    #[test]
    fn what_is_no_pose_is_refused_by_name() {
        let nan = f64::NAN;
        let mut matrix = Pose::IDENTITY.matrix();
        matrix[1][2] = nan;
        let message = |refused: Result<Pose, PoseError>| refused.expect_err("a number is not finite").to_string();
        let entry = "the matrix's entry in row 1, column 2 is NaN, not a finite number";
        assert_eq!(message(Pose::new(matrix, [0.0; 3])), entry);
        let coordinate = "the translation's coordinate 1 is inf, not a finite number";
        assert_eq!(message(Pose::from_translation([0.0, f64::INFINITY, 0.0])), coordinate);
        assert!(matches!(Pose::from_quaternion([0.0; 4], [0.0; 3]), Err(PoseError::NoRotation { .. })));
        assert!(matches!(Pose::from_axis_angle([1.0, 0.0, 0.0], nan, [0.0; 3]), Err(PoseError::NoRotation { .. })));
        assert!(matches!(Pose::from_axis_angle([0.0; 3], 1.0, [0.0; 3]), Err(PoseError::NoRotation { .. })));
    }
}
