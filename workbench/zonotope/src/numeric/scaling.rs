//! Powers of two: taking doubles apart, and scaling and subtracting them without overflow.
//!
//! A product with a power of two is exact as long as the result is a normal double. So methods bring their data to
//! magnitude 1 first, and then neither overflow nor underflow has to be thought of again.

use fearless_simd::{Simd, f64x8};

/// 2^`exponent` as a constant, for exponents of normal doubles: −1022 to 1023.
pub const fn power_of_two(exponent: i32) -> f64 {
    assert!(-1022 <= exponent && exponent <= 1023, "a power of two outside the normal doubles is not made this way");
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// The integers m and e with value = m · 2^e, |m| < 2^53.
pub(crate) fn decompose(value: f64) -> (i64, i32) {
    let bits = value.to_bits();
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (magnitude, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
    (if value.is_sign_negative() { -magnitude } else { magnitude }, exponent)
}

/// `value` · 2^`exponent`: exact unless the result leaves the range of normal doubles.
pub fn scale_by_power_of_two(value: f64, exponent: i64) -> f64 {
    let mut result = value;
    let mut left = exponent.clamp(-2300, 2300);
    while left != 0 {
        let step = left.clamp(-1000, 1000);
        result *= power_of_two(step as i32);
        left -= step;
    }
    result
}

/// A vector times 2^`exponent`; `None` where a coordinate of it is no double.
pub(crate) fn scaled_exactly<const D: usize>(v: &[f64; D], exponent: i64) -> Option<[f64; D]> {
    let scaled = v.map(|c| scale_by_power_of_two(c, exponent));
    let is_exact = |(c, scaled): (&f64, &f64)| scaled.is_finite() && scale_by_power_of_two(*scaled, -exponent) == *c;
    v.iter().zip(&scaled).all(is_exact).then_some(scaled)
}

/// The exponent e with 2^e ≤ |value| < 2^(e+1); `None` for zero.
pub fn binary_exponent(value: f64) -> Option<i32> {
    let (mantissa, exponent) = decompose(value);
    (mantissa != 0).then(|| exponent + 63 - mantissa.unsigned_abs().leading_zeros() as i32)
}

/// The largest magnitude of values, several at a time; 0 of none, and NaN counts as nothing.
pub(crate) fn largest_magnitude(values: &[f64]) -> f64 {
    let (blocks, rest) = values.as_chunks::<8>();
    let larger = |a: f64, b: f64| if b.abs() > a { b.abs() } else { a };
    let lanes = blocks.iter().fold([0.0; 8], |lanes, block| std::array::from_fn(|i| larger(lanes[i], block[i])));
    lanes.iter().chain(rest).copied().fold(0.0, larger)
}

/// The power of two that is not above a positive normal double and more than half of it.
#[inline]
pub(crate) fn power_of_two_below(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & (0x7ff << 52))
}

/// A multiplication by a power of two in two steps: of the two factors, neither leaves the doubles even where the power
/// does.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PowerOfTwo([f64; 2]);

impl PowerOfTwo {
    /// The factor 2^`exponent`, |exponent| ≤ 2044.
    pub(crate) fn new(exponent: i64) -> Self {
        let half = exponent / 2;
        Self([scale_by_power_of_two(1.0, half), scale_by_power_of_two(1.0, exponent - half)])
    }

    /// The value times the power of two: exact unless the result leaves the range of normal doubles.
    #[inline(always)]
    pub(crate) fn apply(&self, value: f64) -> f64 {
        value * self.0[0] * self.0[1]
    }

    /// The same for eight values.
    #[inline(always)]
    pub(crate) fn apply_to_octet<S: Simd>(&self, values: f64x8<S>) -> f64x8<S> {
        values * self.0[0] * self.0[1]
    }
}

/// (p − q) · 2^`exponent`, rounded once if the result is a normal double, even where p − q itself overflows.
pub(crate) fn scaled_difference(p: f64, q: f64, exponent: i64) -> f64 {
    let whole = p - q;
    if whole.is_finite() {
        scale_by_power_of_two(whole, exponent)
    } else {
        // of two doubles whose difference overflows, both halves are exact
        scale_by_power_of_two(p / 2.0 - q / 2.0, exponent + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::level::levels;
    use fearless_simd::{dispatch, prelude::*};
    use proptest::prelude::*;

    #[test]
    fn by_hand() {
        assert_eq!([power_of_two(-1), power_of_two(10), power_of_two(-1022)], [0.5, 1024.0, f64::MIN_POSITIVE]);
        assert_eq!([power_of_two_below(1.5), power_of_two_below(1023.0), power_of_two_below(0.25)], [1.0, 512.0, 0.25]);
        assert_eq!(largest_magnitude(&[1.0, -3.0, f64::NAN, 2.0]), 3.0);
        assert_eq!(largest_magnitude(&[]), 0.0);
        assert_eq!(scaled_difference(f64::MAX, -f64::MAX, -1), f64::MAX);
        assert_eq!(scaled_difference(f64::from_bits(3), f64::from_bits(1), 1), f64::from_bits(4));
        assert_eq!(PowerOfTwo::new(-1074).apply(3.0), f64::from_bits(3));
        assert_eq!(scaled_exactly(&[3.0, -0.0], -1074), Some([f64::from_bits(3), 0.0]));
        assert_eq!([scaled_exactly(&[3.0], -1075), scaled_exactly(&[1.0], 1024)], [None; 2]);
        assert_eq!(scaled_exactly(&[f64::from_bits(3)], 2000), Some([3.0 * power_of_two(926)]));
        assert_eq!(PowerOfTwo::new(2000).apply(f64::from_bits(1)), power_of_two(926));
    }

    properties! {
        #[test]
        fn a_double_over_its_power_of_two_is_about_one(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            let (mantissa, exponent) = decompose(value);
            prop_assert_eq!(Dyadic::new(mantissa.into(), i64::from(exponent)), Dyadic::from_f64(value));
            if let Some(e) = binary_exponent(value) {
                let one = scale_by_power_of_two(value.abs(), -i64::from(e));
                prop_assert!((1.0..2.0).contains(&one));
                if value.is_normal() {
                    prop_assert_eq!(power_of_two_below(value.abs()), power_of_two(e));
                }
            }
        }

        #[test]
        fn differences_are_rounded_once(p in any::<f64>(), q in any::<f64>()) {
            prop_assume!(p.is_finite() && q.is_finite());
            let exact = (Dyadic::from_f64(p) - Dyadic::from_f64(q)).scaled(-2);
            let error = (Dyadic::from_f64(scaled_difference(p, q, -2)) - exact.clone()).abs();
            prop_assert!(error <= exact.abs().scaled(-53) + Dyadic::from_f64(f64::from_bits(1)));
        }
    }

    #[inline(always)]
    fn eight_times<S: Simd>(simd: S, factor: PowerOfTwo, values: &[f64; 8]) -> [f64; 8] {
        let scaled = factor.apply_to_octet(f64x8::from_slice(simd, values));
        std::array::from_fn(|lane| scaled[lane])
    }

    #[test]
    fn eight_values_are_scaled_as_each_of_them_is() {
        let values = [1.0, -3.0, f64::from_bits(1), f64::MAX, -0.0, 0.75, 1e-300, -1e300];
        for exponent in [-1500, -1, 0, 1, 2000] {
            let factor = PowerOfTwo::new(exponent);
            for level in levels() {
                let scaled = dispatch!(level, simd => eight_times(simd, factor, &values));
                assert_eq!(scaled, values.map(|value| factor.apply(value)));
                assert_eq!(scaled[1], scale_by_power_of_two(-3.0, exponent));
            }
        }
    }
}
