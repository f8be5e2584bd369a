//! The vector that a vertex leaves of λ p when the coefficients of its two generators are kept within [−1, 1].
//!
//! If these two are nearly parallel, their coefficients are not known well, and the vector that they leave is small
//! all the same.

use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, UNIT};

/// The vector g + δ_a v_a + δ_b v_b − μ p for δ_a and δ_b in [−1, 1] and μ near λ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rest {
    /// δ_a and δ_b.
    pub(crate) coefficients: [f64; 2],
    /// At least |r|_1, r being that vector.
    pub(super) size: f64,
    /// At least λ / μ − 1.
    pub(super) stretch: f64,
}

impl Rest {
    /// Of the optimum for sure, whose coefficients are within [−1, 1] and whose λ needs no bound but that by its ends.
    pub(super) fn of_sure_optimum(coefficients: [f64; 2]) -> Self {
        Self { coefficients, size: f64::INFINITY, stretch: f64::INFINITY }
    }

    /// From g, the two vectors, their coefficients, g · u and p · u.
    pub(super) fn new(
        sum: &BoundedVector,
        vectors: &[BoundedVector; 2],
        coefficients: [f64; 2],
        [reach, along]: [Bounded; 2],
        p: &BoundedVector,
    ) -> Self {
        let factor = reach.value / along.value;
        let mut coefficients = coefficients.map(|c| c.clamp(-1.0, 1.0));
        // one coefficient after the other, so that the second corrects the error of the first
        for (i, own) in vectors.iter().enumerate() {
            let [a, b] = vectors;
            let rest = |k: usize| {
                let value = a[k].value * coefficients[0] + b[k].value * coefficients[1];
                sum[k].value + value - p[k].value * factor
            };
            let rest = [rest(0), rest(1), rest(2)];
            let own = [own[0].value, own[1].value, own[2].value];
            let [part, square] = [&rest, &own].map(|v| dot(v, &own));
            coefficients[i] = (coefficients[i] - part / square).clamp(-1.0, 1.0);
        }
        let [first, second] = coefficients.map(Bounded::exact);
        let rest = |k: usize| sum[k] + vectors[0][k] * first + vectors[1][k] * second - p[k] * Bounded::exact(factor);
        let size = (rest(0).magnitude() + rest(1).magnitude() + rest(2).magnitude()) * FIVE_ROUNDINGS;
        // twice the relative error to first order, which covers the higher orders while it is small
        let off = reach.error / reach.value + along.error / along.value + 8.0 * UNIT;
        Self { coefficients, size, stretch: if off < 0.25 { 2.0 * off } else { f64::INFINITY } }
    }
}
