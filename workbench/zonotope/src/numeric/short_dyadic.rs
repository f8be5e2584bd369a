//! Exact binary numbers of at most 127 bits: what coordinates of few digits need, without memory of their own.
//!
//! Where the numbers of an input are short (whole numbers, say, or points of a grid), their products and sums are, too,
//! and then an exact sign costs less than with [`Dyadic`], which takes memory for its digits.

use super::dyadic::Dyadic;
use super::scaling::decompose;

/// The number mantissa · 2^exponent; the mantissa is odd or zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ShortDyadic {
    mantissa: i128,
    exponent: i64,
}

impl ShortDyadic {
    #[inline]
    fn new(mantissa: i128, exponent: i64) -> Self {
        if mantissa == 0 {
            return Self { mantissa: 0, exponent: 0 };
        }
        let zeros = mantissa.trailing_zeros();
        Self { mantissa: mantissa >> zeros, exponent: exponent + i64::from(zeros) }
    }

    /// A finite double.
    #[inline]
    pub(crate) fn from_f64(value: f64) -> Self {
        let (mantissa, exponent) = decompose(value);
        Self::new(i128::from(mantissa), i64::from(exponent))
    }

    /// An exact number, if it is short.
    pub(crate) fn of(number: &Dyadic) -> Option<Self> {
        let exponent = number.exponent();
        let mantissa = number.units(exponent);
        // a product of doubles of few digits ends in many zeros
        let zeros = mantissa.trailing_zeros().unwrap_or(0);
        Some(Self::new(i128::try_from(mantissa >> zeros).ok()?, exponent + zeros as i64))
    }

    /// The product, if it is short.
    #[inline]
    pub(crate) fn times(self, other: Self) -> Option<Self> {
        Some(Self::new(self.mantissa.checked_mul(other.mantissa)?, self.exponent + other.exponent))
    }

    /// The sum, if it is short.
    #[inline]
    pub(crate) fn plus(self, other: Self) -> Option<Self> {
        if self.mantissa == 0 || other.mantissa == 0 {
            return Some(if self.mantissa == 0 { other } else { self });
        }
        let (low, high) = if self.exponent <= other.exponent { (self, other) } else { (other, self) };
        let shift = u32::try_from(high.exponent - low.exponent).ok()?;
        let room = high.mantissa.unsigned_abs().leading_zeros();
        // a bit is left for the sign
        let shifted = (shift + 1 < room).then(|| high.mantissa << shift)?;
        Some(Self::new(shifted.checked_add(low.mantissa)?, low.exponent))
    }

    /// The opposite number.
    #[inline]
    pub(crate) fn negated(self) -> Self {
        Self { mantissa: -self.mantissa, ..self }
    }

    /// 1, 0 or −1.
    #[inline]
    pub(crate) fn sign(self) -> i8 {
        self.mantissa.signum() as i8
    }

    /// The number times a power of two.
    #[inline]
    pub(crate) fn scaled(self, exponent: i64) -> Self {
        Self::new(self.mantissa, self.exponent + exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn exact(number: ShortDyadic) -> Dyadic {
        Dyadic::new(number.mantissa.into(), number.exponent)
    }

    fn double() -> impl Strategy<Value = f64> {
        prop_oneof![
            3 => (-1000i32..1000).prop_map(f64::from),
            3 => -1.0..1.0f64,
            1 => any::<f64>().prop_filter("finite", |v| v.is_finite()),
        ]
    }

    properties! {
        #[test]
        fn what_is_short_is_exact(a in double(), b in double(), c in double()) {
            let [x, y, z] = [a, b, c].map(ShortDyadic::from_f64);
            let [p, q, r] = [a, b, c].map(Dyadic::from_f64);
            prop_assert_eq!((exact(x), ShortDyadic::of(&p)), (p.clone(), Some(x)));
            if let Some(product) = x.times(y) {
                prop_assert_eq!(exact(product), &p * &q);
                if let Some(sum) = product.plus(z) {
                    let truth = &p * &q + r.clone();
                    prop_assert_eq!(sum.sign(), truth.sign() as i8);
                    prop_assert_eq!((exact(sum), exact(sum.negated().scaled(3))), (truth.clone(), (-truth).scaled(3)));
                }
            }
        }
    }

    #[test]
    fn what_is_too_long_is_told() {
        let long = ShortDyadic::from_f64(1.0 + f64::EPSILON);
        let square = long.times(long).expect("106 bits");
        assert_eq!(square.times(long), None);
        let sum = |exponent| ShortDyadic::from_f64(1.0).plus(ShortDyadic::from_f64(1.0).scaled(exponent));
        assert_eq!((sum(120).map(ShortDyadic::sign), sum(200), sum(1 << 40)), (Some(1), None, None));
        // a number that is shifted up keeps a bit for the sign and one for a carry
        assert_eq!((sum(125).map(ShortDyadic::sign), sum(126)), (Some(1), None));
    }

    #[test]
    fn a_sum_with_zero_is_short_whatever_the_exponent() {
        let zero = ShortDyadic::from_f64(0.0);
        for number in [-3000, 0, 3000].map(|exponent| ShortDyadic::from_f64(3.0).scaled(exponent)) {
            assert_eq!((number.plus(zero), zero.plus(number)), (Some(number), Some(number)));
        }
    }

    #[test]
    fn a_number_of_all_bits_takes_a_short_one_of_its_unit() {
        let longest = ShortDyadic { mantissa: (1 << 126) + 1, exponent: 7 };
        let sum = longest.plus(ShortDyadic { mantissa: 1, exponent: 7 }).expect("the sum has 126 bits");
        assert_eq!(exact(sum), Dyadic::new((1i128 << 126).into(), 7) + Dyadic::one().scaled(8));
    }
}
