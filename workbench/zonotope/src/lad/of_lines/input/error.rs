//! What a set of lines must satisfy to be a problem.

use thiserror::Error;

use super::weighted_line::WeightedLine;

/// The reason why a set of lines is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LadError {
    /// A coefficient is NaN or infinite.
    #[error("line {line}: {coefficient} is {value}, not a finite number")]
    NonFinite {
        /// The index of the line.
        line: usize,
        /// The name of the coefficient.
        coefficient: &'static str,
        /// The value of the coefficient.
        value: f64,
    },
    /// A weight is below zero.
    #[error("line {line}: the weight {weight} is negative")]
    NegativeWeight {
        /// The index of the line.
        line: usize,
        /// The weight.
        weight: f64,
    },
    /// A coefficient of the linear term is NaN or infinite.
    #[error("the linear term's coordinate {coordinate} is {value}, not a finite number")]
    NonFiniteLinear {
        /// 0 for x, 1 for y.
        coordinate: usize,
        /// The value of the coefficient.
        value: f64,
    },
    /// There are more lines than a 32-bit index can name.
    #[error("{count} lines are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// The number of lines.
        count: usize,
    },
}

pub(super) fn validate(lines: &[WeightedLine], linear: [f64; 2]) -> Result<(), LadError> {
    for (coordinate, value) in linear.into_iter().enumerate() {
        if !value.is_finite() {
            return Err(LadError::NonFiniteLinear { coordinate, value });
        }
    }
    if u32::try_from(lines.len()).is_err() {
        return Err(LadError::TooMany { count: lines.len() });
    }
    for (line, &WeightedLine { normal: [x, y], offset, weight }) in lines.iter().enumerate() {
        for (coefficient, value) in [("normal x", x), ("normal y", y), ("offset", offset), ("weight", weight)] {
            if !value.is_finite() {
                return Err(LadError::NonFinite { line, coefficient, value });
            }
        }
        if weight < 0.0 {
            return Err(LadError::NegativeWeight { line, weight });
        }
    }
    Ok(())
}
