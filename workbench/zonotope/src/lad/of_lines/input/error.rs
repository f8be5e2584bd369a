//! What a set of lines must satisfy to be a problem.

use thiserror::Error;

use super::weighted_line::WeightedLine;
use crate::numeric::non_finite::NonFinite;

/// The reason why a set of lines is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LadError {
    /// A coefficient of a line or of the linear term is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// A weight is below zero.
    #[error("line {line}: the weight {weight} is negative")]
    NegativeWeight {
        /// The index of the line.
        line: usize,
        /// The weight.
        weight: f64,
    },
    /// There are more lines than a 32-bit index can name.
    #[error("{count} lines are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// The number of lines.
        count: usize,
    },
}

pub(super) fn validate(lines: &[WeightedLine], linear: [f64; 2]) -> Result<(), LadError> {
    NonFinite::check_vector("the linear term", &linear)?;
    if u32::try_from(lines.len()).is_err() {
        return Err(LadError::TooMany { count: lines.len() });
    }
    for (line, &WeightedLine { normal: [x, y], offset, weight }) in lines.iter().enumerate() {
        let fields = [("normal x", x), ("normal y", y), ("offset", offset), ("weight", weight)];
        NonFinite::check_fields("line", line, &fields)?;
        if weight < 0.0 {
            return Err(LadError::NegativeWeight { line, weight });
        }
    }
    Ok(())
}
