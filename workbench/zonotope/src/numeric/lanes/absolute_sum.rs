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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::extreme_sum;
    use std::array;

    /// The direction (2, −3, 5, …) and nineteen generators (i − 9, 4, 4, …): blocks, and some that are left.
    fn instance<const D: usize>() -> (Vec<[f64; D]>, [f64; D]) {
        let generators = (0..19).map(|i| array::from_fn(|k| if k == 0 { f64::from(i - 9) } else { 4.0 }));
        (generators.collect(), array::from_fn(|k| [2.0, -3.0, 5.0, 1.0][k]))
    }

    /// The sums over i from −9 to 9 of |2 i|, |2 i − 12|, |2 i + 8| and |2 i + 12|.
    #[test]
    fn whole_numbers_of_one_to_four_dimensions_by_hand() {
        fn sum<const D: usize>() -> f64 {
            let (generators, direction) = instance::<D>();
            absolute_sum(&generators, &direction)
        }
        assert_eq!([sum::<1>(), sum::<2>(), sum::<3>(), sum::<4>()], [180.0, 252.0, 212.0, 252.0]);
    }

    #[test]
    fn an_extreme_vertex_reaches_the_support_function() {
        fn holds<const D: usize>() {
            let (generators, direction) = instance::<D>();
            let vertex = extreme_sum(&generators, &direction);
            assert_eq!(dot(&vertex, &direction), absolute_sum(&generators, &direction));
        }
        holds::<1>();
        holds::<2>();
        holds::<3>();
        holds::<4>();
        // the vertex of the plane: i above 6 has the sign plus, i = 6 is added as it stands
        let (generators, direction) = instance::<2>();
        assert_eq!(extreme_sum(&generators, &direction), [60.0, -44.0]);
    }
}
