//! The fit of a few generators to a body: their zonotope comes as near to it as moving one generator at a time brings it.
//!
//! The support functions are compared along sampled directions. With all generators but b fixed, what is left for
//! |b · u| is known in each direction, and as long as the signs of b · u stay what they are, the weighted least squares
//! of the differences are a quadratic function of b. Its matrix Σ w u uᵀ is the same for every generator, so a step
//! costs two passes over the directions. Weights grow with the differences, so that from round to round the fit turns
//! from the mean of the squares to the largest difference.

use super::sampled_directions::{LANES, SampledDirections};
use crate::numeric::lanes::absolute_sum;
use crate::numeric::linear::{dot, inverse};

/// Sampled directions for each generator: the difference of the support functions changes over the width of a cluster,
/// which this many directions cover.
const DIRECTIONS_PER_GENERATOR: usize = 64;

/// Rounds in which each generator moves once.
const ROUNDS: usize = 40;

/// Weights are the differences to a power that grows from 0 to this one.
const LAST_POWER: f64 = 4.0;

/// A difference counts as this part of the largest one at least, so that no direction is left out.
const LEAST_PART: f64 = 0.05;

/// The differences of two support functions along the sampled directions.
struct Comparison {
    body: Vec<[f64; LANES]>,
    fitted: Vec<[f64; LANES]>,
}

impl Comparison {
    /// The factor by which the fitted zonotope has to grow to reach as far as the body, and by how much it reaches
    /// farther then at most.
    fn growth_and_error(&self) -> (f64, f64) {
        let pairs = || self.body.iter().flatten().zip(self.fitted.iter().flatten());
        let growth = pairs().fold(0.0f64, |growth, (body, fitted)| match *body > growth * fitted {
            true => body / fitted,
            false => growth,
        });
        let error = pairs().fold(0.0f64, |error, (body, fitted)| error.max(growth * fitted - body));
        (growth, error)
    }
}
