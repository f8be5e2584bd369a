//! The support function of a centred zonotope of space in doubles with a bound on its error, in one pass over its
//! generators: nothing about the body must be known before.

pub(super) mod along;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::absolute_sum::absolute_sum_at;
use super::blocks::Block;
use super::level::level;
use super::number::product;
use super::octet::{LANES, splat, total};
use super::rows::Rows;
use crate::numeric::bounded::Bounded;
use crate::numeric::tolerance::{PRODUCT_UNDERFLOW, UNIT};

/// Generators whose sums are taken together where the bound is to be small for any number of them.
const BLOCK: usize = 512;

/// Σ |g · direction| with a bound on its error, in one pass that sums up the magnitudes as well.
#[inline]
pub(crate) fn bounded_sum(generators: Rows<'_>, direction: &[f64; 3]) -> Bounded {
    bounded_sum_near(generators, direction, 0.0)
}

/// The same along an exact direction of which no coordinate is farther than 4 u `size` from the given one.
///
/// A dot product is off by at most 3 u |g|_1 max |direction_k|; the sums are taken in blocks, so a term goes through
/// few additions.
pub(crate) fn bounded_sum_near(generators: Rows<'_>, direction: &[f64; 3], size: f64) -> Bounded {
    let [value, magnitude] = match generators.blocks().zip(generators.sums()) {
        Some((blocks, sums)) => [dispatch!(level(), simd => sum_of_blocks(simd, blocks, direction)), sums.magnitude()],
        None => dispatch!(level(), simd => sums(simd, generators, direction)),
    };
    let additions = (BLOCK + generators.len() / BLOCK + 8) as f64;
    let largest = direction.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let error = UNIT * (additions * value + 4.0 * magnitude * (largest + size)) * (1.0 + 4.0 * additions * UNIT);
    Bounded { value, error: error + generators.len() as f64 * PRODUCT_UNDERFLOW }
}

/// The sum, and Σ |g|_1.
#[inline(always)]
fn sums<S: Simd>(simd: S, generators: Rows<'_>, direction: &[f64; 3]) -> [f64; 2] {
    let (wide, zero) = (splat(simd, direction), f64x8::splat(simd, 0.0));
    let [mut value, mut magnitude] = [0.0; 2];
    for block in generators.chunks(BLOCK) {
        let octets = block.octets();
        let [mut values, mut sizes] = [zero; 2];
        for k in 0..octets.len() {
            let v = octets.load(simd, k);
            values += product(&v, &wide).abs();
            sizes += v[0].abs() + v[1].abs() + v[2].abs();
        }
        value += total(values);
        magnitude += total(sizes);
    }
    [value, magnitude]
}

/// The sum alone, where the magnitude is known.
#[inline(always)]
fn sum_of_blocks<S: Simd>(simd: S, blocks: &[Block], direction: &[f64; 3]) -> f64 {
    let mut value = 0.0;
    for part in blocks.chunks(BLOCK / LANES) {
        value += absolute_sum_at(simd, &part, direction);
    }
    value
}
