//! The problem: points, directions, and the weight of a unit along each direction.

use thiserror::Error;

use crate::numeric::non_finite::NonFinite;

/// Points of R^D, directions and the weight of each direction. A value of this type is valid: it has at least one
/// point, all numbers are finite, and no weight is negative. Directions may be zero, parallel, repeated, and fewer than
/// D; weights may be zero.
#[derive(Debug, Clone, Copy)]
pub struct FixedDirections<'a, const D: usize> {
    points: &'a [[f64; D]],
    directions: &'a [[f64; D]],
    weights: &'a [f64],
}

/// Why points, directions and weights are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum FixedDirectionsError {
    /// There are no points.
    #[error("there are no points")]
    Empty,
    /// A coordinate of a point or of a direction, or a weight, is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// There are not as many weights as directions.
    #[error("{weights} weights for {directions} directions")]
    WeightCount {
        /// The number of directions.
        directions: usize,
        /// The number of weights.
        weights: usize,
    },
    /// A weight is below zero.
    #[error("weight {direction} is {weight}, which is negative")]
    NegativeWeight {
        /// The direction, from 0.
        direction: usize,
        /// Its weight.
        weight: f64,
    },
    /// The answer needs a coefficient or a value above the largest double.
    #[error("a coefficient leaves the range of doubles")]
    OutOfRange,
}

impl<'a, const D: usize> FixedDirections<'a, D> {
    /// A problem from its parts. O(n + k).
    ///
    /// # Errors
    /// The first of these that is wrong: a number is not finite, the numbers of weights and directions differ, a weight
    /// is negative, there are no points.
    pub fn new(
        points: &'a [[f64; D]],
        directions: &'a [[f64; D]],
        weights: &'a [f64],
    ) -> Result<Self, FixedDirectionsError> {
        NonFinite::check_list("point", points)?;
        NonFinite::check_list("direction", directions)?;
        NonFinite::check_numbers("weight", weights)?;
        if weights.len() != directions.len() {
            return Err(FixedDirectionsError::WeightCount { directions: directions.len(), weights: weights.len() });
        }
        if let Some(direction) = weights.iter().position(|w| *w < 0.0) {
            return Err(FixedDirectionsError::NegativeWeight { direction, weight: weights[direction] });
        }
        if points.is_empty() {
            return Err(FixedDirectionsError::Empty);
        }
        Ok(Self { points, directions, weights })
    }

    /// The points.
    pub fn points(&self) -> &'a [[f64; D]] {
        self.points
    }

    /// The directions.
    pub fn directions(&self) -> &'a [[f64; D]] {
        self.directions
    }

    /// The weights, one for each direction.
    pub fn weights(&self) -> &'a [f64] {
        self.weights
    }
}
