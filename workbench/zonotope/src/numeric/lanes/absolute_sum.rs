//! The support function of a centred zonotope in doubles, in one pass over its generators.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::blocks::Source;
use super::level::level;
use super::number::product;
use super::octet::{splat, total};
use super::octets::Octets;
use super::partial_sums::{LANES, in_space, joined};
use crate::numeric::linear::dot;

/// Σ |g · direction| over the generators, in doubles; [`Extents::error`](super::Extents::error) bounds how far it is
/// off. O(n).
///
/// Infinite or NaN where a product or a sum leaves the range of doubles.
#[inline]
pub fn absolute_sum<const D: usize>(generators: &[[f64; D]], direction: &[f64; D]) -> f64 {
    if let Some((generators, direction)) = in_space(generators, direction) {
        return absolute_sum_of(&Octets::new(generators, &[]), direction);
    }
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

/// The same over vectors of space, however they are kept.
pub(crate) fn absolute_sum_of(vectors: &impl Source, direction: &[f64; 3]) -> f64 {
    dispatch!(level(), simd => absolute_sum_at(simd, vectors, direction))
}

/// Four sums take turns, as each addition waits for the one before it.
#[inline(always)]
pub(super) fn absolute_sum_at<S: Simd>(simd: S, vectors: &impl Source, direction: &[f64; 3]) -> f64 {
    let wide = splat(simd, direction);
    let mut sums = [f64x8::splat(simd, 0.0); 4];
    let count = vectors.count();
    let in_turns = count - count % 4;
    for place in (0..in_turns).step_by(4) {
        for (turn, sum) in sums.iter_mut().enumerate() {
            *sum += product(&vectors.octet(simd, place + turn), &wide).abs();
        }
    }
    for place in in_turns..count {
        sums[0] += product(&vectors.octet(simd, place), &wide).abs();
    }
    total((sums[0] + sums[1]) + (sums[2] + sums[3]))
}
