//! The input: weighted planes, validated.

use thiserror::Error;

use crate::numeric::non_finite::NonFinite;

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
    /// A coefficient or the weight of a plane, or a coefficient of the linear term, is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// A weight is below zero.
    #[error("plane {plane}: the weight {weight} is negative")]
    NegativeWeight {
        /// The plane, from 0.
        plane: usize,
        /// The weight.
        weight: f64,
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
        NonFinite::check_vector("the linear term", &linear)?;
        if u32::try_from(planes.len()).is_err() {
            return Err(SpaceLadError::TooMany { count: planes.len() });
        }
        for (plane, &WeightedPlane { normal: [x, y, z], offset, weight }) in planes.iter().enumerate() {
            let fields = [("normal x", x), ("normal y", y), ("normal z", z), ("offset", offset), ("weight", weight)];
            NonFinite::check_fields("plane", plane, &fields)?;
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
