//! The question about a swept volume: an axis line, an angle and a translation.

use thiserror::Error;

use crate::numeric::non_finite::NonFinite;
use crate::zonotope::ZonotopeError;

/// All placements of a body that is turned about an axis line by an angle φ from 0 to `angle`, and then moved by s
/// times a translation, s from 0 to 1: each φ with each s, so that every schedule is covered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sweep {
    pub(in crate::motion) axis_point: [f64; 3],
    pub(in crate::motion) axis: [f64; 3],
    pub(in crate::motion) angle: f64,
    pub(in crate::motion) translation: [f64; 3],
}

/// Why there is no volume.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// A number is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// The axis is the zero vector.
    #[error("the axis of the rotation is zero and has no direction")]
    ZeroAxis,
    /// The angle is below 0.
    #[error("the angle {0} is negative: turn about the opposite axis instead")]
    NegativeAngle(f64),
    /// A coordinate of the volume leaves the range of doubles.
    #[error("the swept volume leaves the range of doubles")]
    OutOfRange,
}

/// Checks that the numbers of a turn about an axis and a translation are finite.
///
/// # Errors
/// The first one that is not, by name.
pub(super) fn check_finite(
    axis_point: [f64; 3],
    axis: [f64; 3],
    angle: f64,
    translation: [f64; 3],
) -> Result<(), NonFinite> {
    NonFinite::check_vector("the axis point", &axis_point)?;
    NonFinite::check_vector("the axis", &axis)?;
    NonFinite::check_vector("the angle", &[angle])?;
    NonFinite::check_vector("the translation", &translation)
}

impl From<ZonotopeError> for SweepError {
    fn from(_: ZonotopeError) -> Self {
        Self::OutOfRange
    }
}

impl Sweep {
    /// A rotation by up to `angle` radians, one or many turns, about the axis of any length through a point, and a
    /// translation.
    ///
    /// # Errors
    /// [`SweepError`] if a number is not finite, the axis is zero or the angle negative.
    pub fn new(axis_point: [f64; 3], axis: [f64; 3], angle: f64, translation: [f64; 3]) -> Result<Self, SweepError> {
        check_finite(axis_point, axis, angle, translation)?;
        if axis == [0.0; 3] {
            return Err(SweepError::ZeroAxis);
        }
        if angle < 0.0 {
            return Err(SweepError::NegativeAngle(angle));
        }
        Ok(Self { axis_point, axis, angle, translation })
    }

    /// A point of the axis line.
    pub fn axis_point(&self) -> [f64; 3] {
        self.axis_point
    }

    /// The direction of the axis, of any length.
    pub fn axis(&self) -> [f64; 3] {
        self.axis
    }

    /// The largest angle in radians.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The whole translation.
    pub fn translation(&self) -> [f64; 3] {
        self.translation
    }
}
