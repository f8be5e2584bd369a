//! An extreme vertex of a centred zonotope in doubles, in one pass over its generators.

use super::partial_sums::{LANES, joined};
use crate::numeric::linear::dot;

/// Σ ± g with the signs of g · direction: an extreme vertex of the centred body, in doubles. O(n).
///
/// Its signs are those of computed dot products: [`Extents::error`](super::Extents::error) bounds by how much the point
/// misses the support function, and [`Extents::point_error`](super::Extents::point_error) how far its coordinates are
/// from those of the vertex with these signs.
#[inline]
pub fn extreme_sum<const D: usize>(generators: &[[f64; D]], direction: &[f64; D]) -> [f64; D] {
    let mut sums = [[0.0; LANES]; D];
    let (blocks, rest) = generators.as_chunks::<LANES>();
    for block in blocks {
        let signs: [f64; LANES] = std::array::from_fn(|lane| dot_or_plus_zero(&block[lane], direction));
        for (axis, sum) in sums.iter_mut().enumerate() {
            for lane in 0..LANES {
                sum[lane] += turned(block[lane][axis], signs[lane]);
            }
        }
    }
    for (lane, generator) in rest.iter().enumerate() {
        let sign = dot_or_plus_zero(generator, direction);
        for (axis, sum) in sums.iter_mut().enumerate() {
            sum[lane] += turned(generator[axis], sign);
        }
    }
    sums.map(joined)
}

/// The dot product, where 0 has the plus sign: a generator that is orthogonal to the direction is added as it stands.
#[inline(always)]
pub(super) fn dot_or_plus_zero<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    0.0 + dot(a, b)
}

/// `value`, or its opposite if `sign` is negative.
#[inline(always)]
fn turned(value: f64, sign: f64) -> f64 {
    f64::from_bits(value.to_bits() ^ (sign.to_bits() & (1 << 63)))
}
