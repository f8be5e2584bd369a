//! Vertices on their way through the sweep: sums of two doubles a coordinate, so that many steps round less than the
//! last one.

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;

/// A vector as an unevaluated sum of two vectors of doubles.
#[derive(Debug, Clone, Copy)]
pub(super) struct Position {
    high: [f64; 3],
    low: [f64; 3],
}

/// Twice a generator: an edge.
pub(super) type Step = Position;

impl Position {
    /// The nearest sum of two doubles to an exact vector: within a relative 2^-99, and 2^-1074 where that is denormal.
    pub(super) fn of_exact(exact: &[Dyadic; 3]) -> Self {
        let pair = exact.each_ref().map(|c| {
            let high = c.to_f64();
            let low = (c - &Dyadic::from_f64(high)).to_f64();
            exact_sum(high, low)
        });
        Self { high: pair.map(|p| p.0), low: pair.map(|p| p.1) }
    }

    /// Half the sum of all edges: the vertex with every generator on its side.
    pub(super) fn north(edges: &[Step]) -> Self {
        let zero = Self { high: [0.0; 3], low: [0.0; 3] };
        let sum = edges.iter().fold(zero, |sum, edge| sum.plus(edge));
        Self { high: sum.high.map(|c| 0.5 * c), low: sum.low.map(|c| 0.5 * c) }
    }

    /// The vertex at the other end of an edge that points here.
    #[inline]
    pub(super) fn across(&self, edge: &Step) -> Self {
        self.plus(&Self { high: edge.high.map(|c| -c), low: edge.low.map(|c| -c) })
    }

    /// The sum, within a relative 2^-102 of the terms' magnitudes.
    #[inline]
    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut result = *self;
        for axis in 0..3 {
            let (sum, error) = exact_sum(self.high[axis], other.high[axis]);
            let error = error + (self.low[axis] + other.low[axis]);
            let high = sum + error;
            result.high[axis] = high;
            result.low[axis] = error - (high - sum);
        }
        result
    }

    /// The opposite vector.
    pub(super) fn reflected(&self) -> Self {
        Self { high: self.high.map(|c| -c), low: self.low.map(|c| -c) }
    }

    /// The vector as doubles times a power of two.
    #[inline]
    pub(super) fn rounded(&self, scale: f64) -> [f64; 3] {
        std::array::from_fn(|axis| (self.high[axis] + self.low[axis]) * scale)
    }
}
