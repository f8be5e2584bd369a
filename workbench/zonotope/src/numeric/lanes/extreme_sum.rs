//! An extreme vertex of a centred zonotope in doubles, in one pass over its generators.

use std::array;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::blocks::Source;
use super::level::level;
use super::number::product;
use super::octet::{self, splat, totals};
use super::octets::Octets;
use super::partial_sums::{LANES, in_space, joined};
use crate::numeric::linear::dot;

/// Σ ± g with the signs of g · direction: an extreme vertex of the centred body, in doubles. O(n).
///
/// Its signs are those of computed dot products: [`Extents::error`](super::Extents::error) bounds by how much the point
/// misses the support function, and [`Extents::point_error`](super::Extents::point_error) how far its coordinates are
/// from those of the vertex with these signs.
#[inline]
pub fn extreme_sum<const D: usize>(generators: &[[f64; D]], direction: &[f64; D]) -> [f64; D] {
    if let Some((generators, direction)) = in_space(generators, direction) {
        let sum = extreme_sum_of(&Octets::new(generators, &[]), direction);
        return array::from_fn(|k| sum[k]);
    }
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

/// The same over vectors of space, however they are kept.
pub(crate) fn extreme_sum_of(vectors: &impl Source, direction: &[f64; 3]) -> [f64; 3] {
    dispatch!(level(), simd => sum(simd, vectors, direction))
}

#[inline(always)]
fn sum<S: Simd>(simd: S, vectors: &impl Source, direction: &[f64; 3]) -> [f64; 3] {
    let wide = splat(simd, direction);
    let zero = f64x8::splat(simd, 0.0);
    let mut sums = [zero; 3];
    for place in 0..vectors.count() {
        let v = vectors.octet(simd, place);
        let value = zero + product(&v, &wide);
        for axis in 0..3 {
            sums[axis] += octet::turned(simd, v[axis], value);
        }
    }
    totals(&sums)
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
