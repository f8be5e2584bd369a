//! The rounding of a sum of generators that a pass takes in, and from which some are taken off afterwards.

use crate::numeric::bounded::BoundedVector;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// The error in doubles of a sum of generators with coefficients in [−1, 1] that is taken from p.
pub(super) struct SumErrors<'a> {
    pub(super) p: &'a BoundedVector,
    /// Σ |v| + |p|, coordinate by coordinate.
    pub(super) sizes: [f64; 3],
    /// The number of generators.
    pub(super) count: usize,
}

impl SumErrors<'_> {
    /// The bound for each coordinate of a sum of the pass from which so many generators, beside a few, were taken off
    /// one by one, or to which they were put back: each of these is one more addition for every term before it.
    pub(super) fn after(&self, additions: usize) -> [f64; 3] {
        let roundings = UNIT * (self.count / 2 + 32 + additions) as f64;
        let lost = (self.count + additions) as f64 * PRODUCT_UNDERFLOW;
        [0, 1, 2].map(|k| (self.p[k].error + roundings * self.sizes[k]) * LONG_SUM + lost)
    }
}
