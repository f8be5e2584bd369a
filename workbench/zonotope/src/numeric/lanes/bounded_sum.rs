//! The support function of a centred zonotope of space in doubles with a bound on its error, in one pass over its
//! generators: nothing about the body must be known before.

use wide::f64x2;

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
    let [x, y, z] = *direction;
    // two generators in the order in which they lie in memory
    let wide = [[x, y], [z, x], [y, z]].map(f64x2::new);
    let (mut value, mut magnitude) = (0.0, 0.0);
    for block in generators.chunks(BLOCK) {
        let mut values = [f64x2::default(); 2];
        let mut sizes = [f64x2::default(); 3];
        let mut read = |[[a, b, c], [d, e, f]]: [[f64; 3]; 2], values: &mut f64x2| {
            let pair = [[a, b], [c, d], [e, f]].map(f64x2::new);
            let [first, middle, last] = [pair[0] * wide[0], pair[1] * wide[1], pair[2] * wide[2]];
            let [ends, others] = f64x2::transpose([first, last]);
            *values += (ends + others + middle).abs();
            for (size, c) in sizes.iter_mut().zip(pair) {
                *size += c.abs();
            }
        };
        let (fours, rest) = block.as_chunks::<4>();
        for [a, b, c, d] in fours {
            read([*a, *b], &mut values[0]);
            read([*c, *d], &mut values[1]);
        }
        for generator in rest {
            read([*generator, [0.0; 3]], &mut values[0]);
        }
        value += (values[0] + values[1]).reduce_add();
        magnitude += (sizes[0] + sizes[1] + sizes[2]).reduce_add();
    }
    let additions = (BLOCK + generators.len() / BLOCK + 8) as f64;
    let largest = direction.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let error = UNIT * (additions * value + 4.0 * magnitude * (largest + size)) * (1.0 + 4.0 * additions * UNIT);
    Bounded { value, error: error + generators.len() as f64 * PRODUCT_UNDERFLOW }
}
