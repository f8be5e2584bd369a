//! The support function of a centred zonotope of space in doubles with a bound on its error, in one pass over its
//! generators: nothing about the body must be known before.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::level::level;
use super::number::product;
use super::octet::{Octets, splat, total};
use crate::numeric::bounded::Bounded;
use crate::numeric::tolerance::{PRODUCT_UNDERFLOW, UNIT};

/// Generators whose sums are taken together where the bound is to be small for any number of them.
const BLOCK: usize = 512;

/// Σ |g · direction| with a bound on its error, in one pass that sums up the magnitudes as well.
#[inline]
pub(crate) fn bounded_sum(generators: &[[f64; 3]], direction: &[f64; 3]) -> Bounded {
    bounded_sum_near(generators, direction, 0.0)
}

/// The same along an exact direction of which no coordinate is farther than 4 u `size` from the given one.
///
/// A dot product is off by at most 3 u |g|_1 max |direction_k|; the sums are taken in blocks, so a term goes through
/// few additions.
pub(crate) fn bounded_sum_near(generators: &[[f64; 3]], direction: &[f64; 3], size: f64) -> Bounded {
    let [value, magnitude] = dispatch!(level(), simd => sums(simd, generators, direction));
    let additions = (BLOCK + generators.len() / BLOCK + 8) as f64;
    let largest = direction.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let error = UNIT * (additions * value + 4.0 * magnitude * (largest + size)) * (1.0 + 4.0 * additions * UNIT);
    Bounded { value, error: error + generators.len() as f64 * PRODUCT_UNDERFLOW }
}

/// The sum, and Σ |g|_1.
#[inline(always)]
fn sums<S: Simd>(simd: S, generators: &[[f64; 3]], direction: &[f64; 3]) -> [f64; 2] {
    let (wide, zero) = (splat(simd, direction), f64x8::splat(simd, 0.0));
    let [mut value, mut magnitude] = [0.0; 2];
    for block in generators.chunks(BLOCK) {
        let octets = Octets::new(block);
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
