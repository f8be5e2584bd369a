//! The support function of a centred zonotope in doubles, in one pass over its generators.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::level::level;
use super::number::product;
use super::octet::{Octets, splat, total};
use super::partial_sums::{LANES, in_space, joined};
use crate::numeric::linear::dot;

/// Σ |g · direction| over the generators, in doubles; [`Extents::error`](super::Extents::error) bounds how far it is
/// off. O(n).
///
/// Infinite or NaN where a product or a sum leaves the range of doubles.
#[inline]
pub fn absolute_sum<const D: usize>(generators: &[[f64; D]], direction: &[f64; D]) -> f64 {
    if let Some((generators, direction)) = in_space(generators, direction) {
        return dispatch!(level(), simd => sum(simd, generators, direction));
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

#[inline(always)]
fn sum<S: Simd>(simd: S, generators: &[[f64; 3]], direction: &[f64; 3]) -> f64 {
    let (wide, octets) = (splat(simd, direction), Octets::new(generators));
    let mut sum = f64x8::splat(simd, 0.0);
    for k in 0..octets.len() {
        sum += product(&octets.load(simd, k), &wide).abs();
    }
    total(sum)
}
