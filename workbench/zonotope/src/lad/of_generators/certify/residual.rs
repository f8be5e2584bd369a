//! What a vertex leaves of λ p when the coefficients of its two generators are kept within [−1, 1].
//!
//! Where these two are nearly parallel, their coefficients are not known well, and the vector that they leave is small
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
            let value = |k: usize| vectors.iter().zip(coefficients).map(|(v, c)| v[k].value * c).sum::<f64>();
            let rest = [0, 1, 2].map(|k| sum[k].value + value(k) - p[k].value * factor);
            let own = own.map(|c| c.value);
            let [part, square] = [&rest, &own].map(|v| dot(v, &own));
            coefficients[i] = (coefficients[i] - part / square).clamp(-1.0, 1.0);
        }
        let [first, second] = coefficients.map(Bounded::exact);
        let rest =
            [0, 1, 2].map(|k| sum[k] + vectors[0][k] * first + vectors[1][k] * second - p[k] * Bounded::exact(factor));
        let size = rest.iter().map(|c| c.magnitude()).sum::<f64>() * FIVE_ROUNDINGS;
        // twice the relative error to first order, which covers the higher orders while it is small
        let off = reach.error / reach.value + along.error / along.value + 8.0 * UNIT;
        Self { coefficients, size, stretch: if off < 0.25 { 2.0 * off } else { f64::INFINITY } }
    }
}
