//! The support function of a centred zonotope of space to about twice the digits of a double, in one pass over its
//! generators.
//!
//! The product of two doubles and what rounding it leaves behind are two doubles (Dekker); so are their sums (Knuth).
//! The large parts of all products are summed up with what each addition rounds off, the small parts as they are. That
//! is more arithmetic than a pass in doubles has, on generators that are read once as well.

mod exact;
mod extreme;
pub(crate) mod pair_lanes;

pub(crate) use exact::{Along, add_extreme_exactly};
pub(crate) use extreme::extreme_sum_in_pairs;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::level::level;
use super::number::sum_and_rest;
use super::octet::{LANES, splat, total, turned};
use super::octets::Octets;
use super::rows::Rows;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, SUM_IN_PAIRS};

/// Generators whose small parts are added up before they join those of the others, so that few roundings take part.
const BLOCK: usize = 512;

/// 2^27 + 1: a double times this, less what that is more than the double, is its first 26 bits.
const SPLITTER: f64 = ((1_u64 << 27) + 1) as f64;

/// A coordinate of the direction as two doubles, the first of them as the sum of two of at most 26 bits.
#[derive(Clone, Copy)]
struct Factor<S: Simd> {
    high: f64x8<S>,
    low: f64x8<S>,
    halves: [f64x8<S>; 2],
}

/// Σ |g · direction|, with a bound for its error; nothing is known of it where a product leaves the range of doubles.
pub(crate) fn absolute_sum_in_pairs(rows: Rows<'_>, direction: &[BoundedDoubleDouble; 3]) -> BoundedDoubleDouble {
    let parts = direction.map(|c| c.parts());
    let largest = parts.iter().fold(0.0f64, |m, (pair, _)| m.max(pair.high.abs()));
    let off = parts.iter().fold(0.0f64, |m, (_, error)| m.max(*error));
    let pairs = parts.map(|(pair, _)| [pair.high, pair.low]);
    let mut sum = BoundedDoubleDouble::exact(0.0);
    for block in rows.chunks(BLOCK) {
        let [head, tail, length] = dispatch!(level(), simd => sum_of_block(simd, block.octets(), &pairs));
        let error = length * LONG_SUM * (SUM_IN_PAIRS * largest + off) + block.len() as f64 * PRODUCT_UNDERFLOW;
        sum = sum + BoundedDoubleDouble::of_parts(head, tail, error);
    }
    sum
}

/// The sum as two doubles, and Σ |g|_1.
#[inline(always)]
fn sum_of_block<S: Simd>(simd: S, octets: Octets<'_>, direction: &[[f64; 2]; 3]) -> [f64; 3] {
    let high = splat(simd, &direction.map(|[high, _]| high));
    let low = splat(simd, &direction.map(|[_, low]| low));
    let splitter = f64x8::splat(simd, SPLITTER);
    let zero = f64x8::splat(simd, 0.0);
    let mut factors = [Factor { high: zero, low: zero, halves: [zero; 2] }; 3];
    for k in 0..3 {
        factors[k] = Factor { high: high[k], low: low[k], halves: halves(high[k], splitter) };
    }
    let [mut head, mut tail, mut length] = [zero; 3];
    for place in 0..octets.len() {
        let v = octets.load(simd, place);
        let (x, x_rest) = product(v[0], &factors[0], splitter);
        let (y, y_rest) = product(v[1], &factors[1], splitter);
        let (z, z_rest) = product(v[2], &factors[2], splitter);
        let (sum, first_rest) = sum_and_rest(x, y);
        let (sum, second_rest) = sum_and_rest(sum, z);
        let rest = (first_rest + second_rest) + ((x_rest + y_rest) + z_rest);
        let sign = sum + rest;
        let (joined, rounded_off) = sum_and_rest(head, turned(simd, sum, sign));
        head = joined;
        tail += rounded_off + turned(simd, rest, sign);
        length += v[0].abs() + v[1].abs() + v[2].abs();
    }
    let mut heads = [0.0; LANES];
    head.store_slice(&mut heads);
    let mut sum = [0.0, total(tail)];
    for lane in heads {
        let (joined, rest) = exact_sum(sum[0], lane);
        sum = [joined, sum[1] + rest];
    }
    [sum[0], sum[1], total(length)]
}

/// v · u as the rounded product with the first double of u, and what it lacks of the product with both.
#[inline(always)]
fn product<S: Simd>(v: f64x8<S>, u: &Factor<S>, splitter: f64x8<S>) -> (f64x8<S>, f64x8<S>) {
    let rounded = v * u.high;
    let [head, tail] = halves(v, splitter);
    let rest = ((head * u.halves[0] - rounded) + head * u.halves[1] + tail * u.halves[0]) + tail * u.halves[1];
    (rounded, rest + v * u.low)
}

/// A number as the sum of two of at most 26 bits.
#[inline(always)]
fn halves<S: Simd>(value: f64x8<S>, splitter: f64x8<S>) -> [f64x8<S>; 2] {
    let scaled = splitter * value;
    let head = scaled - (scaled - value);
    [head, value - head]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::numeric::scaling::power_of_two;
    use proptest::prelude::*;

    /// Σ |g · u|, exactly.
    fn truth(generators: &[[f64; 3]], u: &[Dyadic; 3]) -> Dyadic {
        generators.iter().fold(Dyadic::zero(), |sum, g| {
            let terms = [0, 1, 2].map(|k| Dyadic::from_f64(g[k]) * u[k].clone());
            sum + terms.into_iter().fold(Dyadic::zero(), |a, b| a + b).abs()
        })
    }

    properties! {
        #[test]
        fn sums_keep_their_bounds_and_are_the_same_at_each_level(
            (generators, direction) in vectors(), low in -1.0..1.0f64, exponent in -60..60i32,
        ) {
            let generators: Vec<[f64; 3]> =
                generators.iter().map(|g| g.map(|c| c * power_of_two(exponent))).collect();
            let pair = direction.map(|c| BoundedDoubleDouble::of_parts(c, low * c * power_of_two(-54), 0.0));
            let exact = truth(&generators, &pair.map(BoundedDoubleDouble::to_dyadic));
            let known = laid_out(&generators);
            for rows in [Rows::new(&generators), Rows::laid_out(&generators, &known)] {
                let found = at_each_level(|| absolute_sum_in_pairs(rows, &pair));
                let bits = |sum: &BoundedDoubleDouble| {
                    let (pair, error) = sum.parts();
                    [pair.high, pair.low, error].map(f64::to_bits)
                };
                prop_assert!(found.iter().all(|sum| bits(sum) == bits(&found[0])));
                let (sum, error) = found[0].parts();
                if error == f64::INFINITY {
                    continue;
                }
                let off = (Dyadic::from_f64(sum.high) + Dyadic::from_f64(sum.low) - exact.clone()).abs();
                prop_assert!(off <= Dyadic::from_f64(error), "{error}");
            }
        }
    }

    #[test]
    fn terms_that_cancel_keep_their_digits() {
        // (3, 1, 1) and nearly orthogonal directions: all products but the last bits cancel
        let generators: Vec<[f64; 3]> = (0..700).map(|i| [1.0, -3.0, f64::from(i) * power_of_two(-60)]).collect();
        let sum = absolute_sum_in_pairs(Rows::new(&generators), &[3.0, 1.0, 1.0].map(BoundedDoubleDouble::exact));
        let (pair, error) = sum.parts();
        assert_eq!((pair.high, pair.low), (f64::from(700 * 699 / 2) * power_of_two(-60), 0.0));
        assert!(error < 1e-8 * pair.high, "{error}");
    }

    #[test]
    fn overflow_leaves_nothing_known() {
        let sum = absolute_sum_in_pairs(Rows::new(&[[f64::MAX; 3]]), &[1.0; 3].map(BoundedDoubleDouble::exact));
        assert!(!sum.is_known());
    }

    /// The magnitudes add up to 21, and the largest coordinate of the direction is 2.
    #[test]
    fn bounds_worked_out_by_hand() {
        let generators = [[1.0, -2.0, 4.0]; 3];
        let error = |off: f64| {
            let direction = [1.0, 2.0, -0.5].map(|c| BoundedDoubleDouble::of_parts(c, 0.0, off));
            absolute_sum_in_pairs(Rows::new(&generators), &direction).parts().1
        };
        let of = |expected: f64| expected..1.1 * expected;
        assert!(of(42.0 * SUM_IN_PAIRS).contains(&error(0.0)), "{}", error(0.0));
        assert!(of(21.0 * power_of_two(-20)).contains(&error(power_of_two(-20))));
        let zeros = absolute_sum_in_pairs(Rows::new(&[[0.0; 3]; 3]), &[1.0; 3].map(BoundedDoubleDouble::exact));
        assert!(of(3.0 * PRODUCT_UNDERFLOW).contains(&zeros.parts().1));
    }

    /// The product of 1 + 2^-30 with itself, less 1 + 2^-29: all of it is what rounding a product leaves behind.
    #[test]
    fn a_product_of_which_the_rounded_terms_cancel_has_its_sign() {
        let half = 1.0 + power_of_two(-30);
        for sign in [1.0, -1.0] {
            let generator = [half, -1.0 - power_of_two(-29), 0.0].map(|c| sign * c);
            let direction = [half, 1.0, 0.0].map(BoundedDoubleDouble::exact);
            let (pair, _) = absolute_sum_in_pairs(Rows::new(&[generator]), &direction).parts();
            assert_eq!((pair.high, pair.low), (power_of_two(-60), 0.0));
        }
    }
}
