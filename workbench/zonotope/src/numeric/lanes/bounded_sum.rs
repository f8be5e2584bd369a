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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::numeric::linear::{dot, max_norm, sum_norm};
    use crate::numeric::scaling::power_of_two;
    use proptest::prelude::*;

    properties! {
        #![proptest_config(crate::property_cases::config(1000))]

        /// The exact direction is off by as much as may be, to one side and to the other.
        #[test]
        fn bounds_hold_along_directions_that_were_rounded((generators, direction) in vectors(), sides in 0u8..8) {
            let size = max_norm(&direction);
            let off = Dyadic::from_f64(size).scaled(-51);
            let side = |k: usize| if sides & (1 << k) == 0 { off.clone() } else { -off.clone() };
            let exact = [0, 1, 2].map(|k| Dyadic::from_f64(direction[k]) + side(k));
            let along = |g: &[f64; 3]| dot(&g.map(Dyadic::from_f64), &exact).abs();
            let truth = generators.iter().fold(Dyadic::zero(), |sum, g| sum + along(g));
            let magnitude: f64 = generators.iter().map(sum_norm).sum();
            let known = laid_out(&generators);
            for rows in [Rows::new(&generators), Rows::laid_out(&generators, &known)] {
                let sum = bounded_sum_near(rows, &direction, size);
                if sum.value.is_finite() && sum.error.is_finite() {
                    prop_assert!((Dyadic::from_f64(sum.value) - truth.clone()).abs() <= Dyadic::from_f64(sum.error));
                    let room = 300.0 * (magnitude * UNIT) * (2.0 * size) + 50.0 * PRODUCT_UNDERFLOW;
                    prop_assert!(sum.error <= room, "{} {room}", sum.error);
                }
            }
        }
    }

    fn close(value: f64, expected: f64) -> bool {
        (expected..expected * (1.0 + 1e-9)).contains(&value)
    }

    /// The value is 1024 · |1.5 − 1 + 0|, the sum of the magnitudes 1024 · 7: the bound is (522 · 512 + 4 · 7168 · (2 +
    /// 8)) u, and the roundings of 522 additions within itself.
    #[test]
    fn a_bound_worked_out_by_hand() {
        let generators = [[3.0, -4.0, 0.0]; 1024];
        let sum = bounded_sum_near(Rows::new(&generators), &[0.5, 0.25, 2.0], 8.0);
        assert_eq!(sum.value, 512.0);
        let more = (sum.error / (553_984.0 * UNIT) - 1.0) / UNIT;
        assert!((2080.0..2096.0).contains(&more), "{more}");
        let exact = bounded_sum(Rows::new(&generators[..1]), &[0.5, 0.25, 2.0]);
        assert!(exact.value == 0.5 && close(exact.error, (260.0 + 56.0) * UNIT));
        let flat = bounded_sum(Rows::new(&[[1.0, -2.0, 4.0]]), &[1.0, 0.0, 0.0]);
        assert!(flat.value == 1.0 && close(flat.error, (520.0 + 28.0) * UNIT));
    }

    /// The sum of the largest coordinates stands in for that of the magnitudes: 3 · 4 · 1024 for 7 · 1024.
    #[test]
    fn a_bound_from_known_sums_worked_out_by_hand() {
        let generators = [[3.0, -4.0, 0.0]; 1024];
        let known = laid_out(&generators);
        let sum = bounded_sum(Rows::laid_out(&generators, &known), &[0.5, 0.25, 2.0]);
        assert!(sum.value == 512.0 && close(sum.error, (522.0 * 512.0 + 4.0 * 12_288.0 * 2.0) * UNIT));
    }

    #[test]
    fn zeros_leave_the_room_for_underflow() {
        let sum = bounded_sum(Rows::new(&[[0.0; 3]; 3]), &[1.0; 3]);
        assert_eq!((sum.value, sum.error), (0.0, 3.0 * PRODUCT_UNDERFLOW));
    }

    /// The terms are 2^53 and 1023 ones: those that share a sum with the first are lost to rounding.
    #[test]
    fn a_large_term_takes_digits_from_its_own_block_alone() {
        let mut generators = [[1.0, 0.0, 0.0]; 1024];
        let large = power_of_two(53);
        generators[0][0] = large;
        let known = laid_out(&generators);
        let of = |rows| bounded_sum(rows, &[1.0, 0.0, 0.0]).value - large;
        assert_eq!(of(Rows::new(&generators)), f64::from(1024 - BLOCK as u32 / 8));
        // four sums take turns in each lane
        assert_eq!(of(Rows::laid_out(&generators, &known)), f64::from(1024 - BLOCK as u32 / 32));
    }
}
