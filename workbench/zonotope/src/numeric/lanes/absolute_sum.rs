//! The support function of a centred zonotope in doubles, in one pass over its generators.

use super::partial_sums::{LANES, joined};
use crate::numeric::linear::dot;

/// Σ |g · direction| over the generators, in doubles; [`Extents::error`](super::Extents::error) bounds how far it is
/// off. O(n).
///
/// Infinite or NaN where a product or a sum leaves the range of doubles.
#[inline]
pub fn absolute_sum<const D: usize>(generators: &[[f64; D]], direction: &[f64; D]) -> f64 {
    let mut sums = [0.0; LANES];
    let (blocks, rest) = generators.as_chunks::<LANES>();
    for block in blocks {
        for (sum, generator) in sums.iter_mut().zip(block) {
            *sum += dot(generator, direction).abs();
        }
    }
    for (sum, generator) in sums.iter_mut().zip(rest) {
        *sum += dot(generator, direction).abs();
    }
    joined(sums)
}
