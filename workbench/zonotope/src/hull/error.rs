//! What the hull refuses.

use thiserror::Error;

/// The largest number of points: indices and one flag fit in 32 bits.
pub const MAX_POINTS: usize = (1 << 31) - 1;

/// Why a set of points has no hull.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HullError {
    /// There are no points.
    #[error("there are no points")]
    Empty,
    /// A coordinate is NaN or infinite; the first such in the order of the input.
    #[error("point {index}, coordinate {coordinate} is {value}")]
    NonFinite {
        /// Position of the point in the input.
        index: usize,
        /// 0 for x, 1 for y.
        coordinate: usize,
        /// The coordinate.
        value: f64,
    },
    /// There are more than [`MAX_POINTS`] points.
    #[error("{count} points are more than the {MAX_POINTS} that can be indexed")]
    TooMany {
        /// How many there are.
        count: usize,
    },
}

/// Refuses a number of points that is zero or cannot be indexed.
pub(super) fn check_count(count: usize) -> Result<(), HullError> {
    match count {
        0 => Err(HullError::Empty),
        1..=MAX_POINTS => Ok(()),
        _ => Err(HullError::TooMany { count }),
    }
}

/// Refuses coordinates that are not finite.
pub(super) fn check_finite(points: &[[f64; 2]]) -> Result<(), HullError> {
    match points.as_flattened().iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(at) => Err(HullError::NonFinite { index: at / 2, coordinate: at % 2, value: points[at / 2][at % 2] }),
    }
}
