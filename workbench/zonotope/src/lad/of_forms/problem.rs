//! The input: weighted planes, validated.

use thiserror::Error;

/// One term weight · |normal · x + offset| of the objective.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeightedPlane {
    /// The coefficients of x, y and z.
    pub normal: [f64; 3],
    /// The constant coefficient.
    pub offset: f64,
    /// The weight, not negative.
    pub weight: f64,
}

/// Minimise linear · x + Σ weight_i |normal_i · x + offset_i| over space. Every number is finite, no weight negative.
#[derive(Debug, Clone, PartialEq)]
pub struct SpaceLadProblem {
    planes: Vec<WeightedPlane>,
    linear: [f64; 3],
}

/// Why planes are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SpaceLadError {
    /// A coefficient or a weight is NaN or infinite.
    #[error("plane {plane} holds {value}, not a finite number")]
    NonFinite {
        /// The plane, from 0.
        plane: usize,
        /// The value.
        value: f64,
    },
    /// A weight is below zero.
    #[error("plane {plane}: the weight {weight} is negative")]
    NegativeWeight {
        /// The plane, from 0.
        plane: usize,
        /// The weight.
        weight: f64,
    },
    /// A coefficient of the linear term is NaN or infinite.
    #[error("the linear term's coordinate {coordinate} is {value}, not a finite number")]
    NonFiniteLinear {
        /// The coordinate, from 0.
        coordinate: usize,
        /// Its value.
        value: f64,
    },
    /// There are more planes than a 32-bit index can name.
    #[error("{count} planes are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// How many planes there are.
        count: usize,
    },
}

impl SpaceLadProblem {
    /// Validates the planes. O(n).
    ///
    /// # Errors
    /// [`SpaceLadError`] on the first number that is not finite, the first negative weight, or too many planes.
    pub fn new(planes: Vec<WeightedPlane>, linear: [f64; 3]) -> Result<Self, SpaceLadError> {
        if let Some(coordinate) = linear.iter().position(|v| !v.is_finite()) {
            return Err(SpaceLadError::NonFiniteLinear { coordinate, value: linear[coordinate] });
        }
        if u32::try_from(planes.len()).is_err() {
            return Err(SpaceLadError::TooMany { count: planes.len() });
        }
        for (plane, &WeightedPlane { normal: [x, y, z], offset, weight }) in planes.iter().enumerate() {
            if let Some(value) = [x, y, z, offset, weight].into_iter().find(|v| !v.is_finite()) {
                return Err(SpaceLadError::NonFinite { plane, value });
            }
            if weight < 0.0 {
                return Err(SpaceLadError::NegativeWeight { plane, weight });
            }
        }
        Ok(Self { planes, linear })
    }

    /// The planes.
    pub fn planes(&self) -> &[WeightedPlane] {
        &self.planes
    }

    /// The linear term.
    pub fn linear(&self) -> [f64; 3] {
        self.linear
    }
}
