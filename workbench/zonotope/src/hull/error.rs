//! What the hull refuses.

use thiserror::Error;

use crate::numeric::non_finite::NonFinite;

/// The largest number of points: indices and one flag fit in 32 bits.
pub const MAX_POINTS: usize = (1 << 31) - 1;

/// Why a set of points has no hull.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HullError {
    /// There are no points.
    #[error("there are no points")]
    Empty,
    /// A coordinate is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
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
