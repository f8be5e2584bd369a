//! Doubles with a bound on their distance from an exact value, times a power of two of their own, for filters of a few
//! operations on numbers of all sizes.
//!
//! A product of three coordinates leaves the range of doubles where they are as large as 2^342 or as small as 2^−342,
//! and then [`Bounded`] decides nothing. Here the doubles stay between 2^−[`LARGEST_EXPONENT`] and its inverse, so that
//! what they lose is as in [`Bounded`]: u = 2^-53 times each result, and less than 2^-900 for underflow of a bound.

use std::ops::{Add, Mul, Sub};

use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::ring_of_values;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::{DIFFERENCE_OF_LEADING_DOUBLES, FIVE_ROUNDINGS, PRODUCT_UNDERFLOW, UNIT};

/// The exact value is 2^`exponent` times one that `part` bounds; its double is 0 or has an exponent of
/// [`LARGEST_EXPONENT`] at most in magnitude.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BoundedWide {
    part: Bounded,
    exponent: i64,
}

/// A double of which the exponent exceeds this in magnitude is scaled to about 1.
const LARGEST_EXPONENT: i32 = 100;

/// Of two summands whose powers of two are further apart than this, the smaller one is only an error.
const NEGLIGIBLE_DISTANCE: i64 = 400;

impl BoundedWide {
    const ZERO: Self = Self { part: Bounded::exact(0.0), exponent: 0 };

    /// A finite double that is the exact value.
    pub(crate) fn exact(value: f64) -> Self {
        Self::normalized(Bounded::exact(value), 0)
    }

    /// An exact number.
    pub(crate) fn of(number: &Dyadic) -> Self {
        let (value, exponent) = number.leading();
        Self::normalized(Bounded { value, error: DIFFERENCE_OF_LEADING_DOUBLES * value.abs() }, exponent)
    }

    /// The sum of two finite doubles.
    pub(crate) fn of_sum([head, tail]: [f64; 2]) -> Self {
        Self::exact(head) + Self::exact(tail)
    }

    /// The sign of the exact value if it is certain and not zero.
    pub(crate) fn sign(self) -> Option<i8> {
        self.part.sign()
    }

    /// The opposite value.
    pub(crate) fn negated(self) -> Self {
        Self { part: self.part.negated(), ..self }
    }

    /// The number with its double scaled to about 1 where it is far from it.
    fn normalized(part: Bounded, exponent: i64) -> Self {
        match binary_exponent(part.value) {
            None if part.error == 0.0 => Self::ZERO,
            Some(own) if own.abs() > LARGEST_EXPONENT => {
                // A denormal double becomes a normal one without rounding. The bound may round, or vanish.
                let [value, error] = [part.value, part.error].map(|v| scale_by_power_of_two(v, -i64::from(own)));
                let error = if part.error == 0.0 { 0.0 } else { error * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW };
                Self { part: Bounded { value, error }, exponent: exponent + i64::from(own) }
            }
            _ => Self { part, exponent },
        }
    }

    fn is_zero(&self) -> bool {
        self.part.value == 0.0 && self.part.error == 0.0
    }

    /// The part in units of a power of two that is no less than its own.
    fn in_units_of(&self, exponent: i64) -> Bounded {
        let down = self.exponent - exponent;
        if down == 0 {
            return self.part;
        }
        if down < -NEGLIGIBLE_DISTANCE {
            let largest = scale_by_power_of_two(self.part.magnitude(), -NEGLIGIBLE_DISTANCE);
            return Bounded { value: 0.0, error: largest * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW };
        }
        // The double is far from the least normal one, the bound may not be.
        let [value, error] = [self.part.value, self.part.error].map(|v| scale_by_power_of_two(v, down));
        let error = if self.part.error == 0.0 { 0.0 } else { error * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW };
        Bounded { value, error }
    }
}

impl BoundedWide {
    fn plus(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let exponent = self.exponent.max(other.exponent);
        let [a, b] = [self, other].map(|summand| summand.in_units_of(exponent));
        let value = a.value + b.value;
        let error = (a.error + b.error + UNIT * value.abs()) * FIVE_ROUNDINGS;
        Self::normalized(Bounded { value, error }, exponent)
    }
}

impl Add for BoundedWide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl Sub for BoundedWide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.plus(other.negated())
    }
}

impl Mul for BoundedWide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        Self::normalized(self.part * other.part, self.exponent + other.exponent)
    }
}

ring_of_values!(BoundedWide, BoundedWide::ZERO, BoundedWide { part: Bounded::exact(1.0), exponent: 0 });

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear;
    use crate::numeric::linear::{cross, dot};
    use proptest::prelude::*;

    /// A double of any size, often at an end of the range, zero, or one more than a power of two.
    fn double(bits: u64) -> f64 {
        let value = f64::from_bits(bits);
        match bits % 8 {
            _ if !value.is_finite() => f64::MAX,
            0 => 0.0,
            1 => f64::from_bits(bits % 1024 + 1),
            2 => f64::from_bits(bits & !0xf_ffff_ffff_ffff),
            3 => (value % 16.0).trunc(),
            _ => value,
        }
    }

    properties! {
        #![proptest_config(crate::property_cases::config(4096))]

        #[test]
        fn bounds_hold_for_numbers_of_all_sizes(bits in proptest::array::uniform9(any::<u64>())) {
            let rows: [[f64; 3]; 3] = [0, 3, 6].map(|i| [0, 1, 2].map(|k| double(bits[i + k])));
            let exactly = rows.map(exact_linear::exact);
            let truth = dot(&exact_linear::cross(&exactly[0], &exactly[1]), &exactly[2]);
            let [a, b, c] = rows.map(|row| row.map(BoundedWide::exact));
            let wide = dot(&cross(&a, &b), &c);
            let off = (truth.clone() - Dyadic::from_f64(wide.part.value).scaled(wide.exponent)).abs();
            prop_assert!(off <= Dyadic::from_f64(wide.part.error).scaled(wide.exponent), "{rows:?} {wide:?}");
            if let Some(sign) = wide.sign() {
                prop_assert_eq!(sign, truth.sign() as i8);
            }
            let of_truth = BoundedWide::of(&truth);
            prop_assert!(truth.is_zero() || of_truth.sign() == Some(truth.sign() as i8), "{of_truth:?}");
            let sum = BoundedWide::of_sum([rows[0][0], rows[0][1]]);
            let off = (&exactly[0][0] + &exactly[0][1]) - Dyadic::from_f64(sum.part.value).scaled(sum.exponent);
            prop_assert!(off.abs() <= Dyadic::from_f64(sum.part.error).scaled(sum.exponent), "{sum:?}");
        }
    }

    #[test]
    fn determinants_far_beyond_the_doubles_have_their_sign() {
        let [least, most] = [f64::from_bits(1), f64::MAX].map(BoundedWide::exact);
        assert_eq!((least * least * least).sign(), Some(1));
        assert_eq!((most * most * most - least).sign(), Some(1));
        assert_eq!((least * least - most * most).sign(), Some(-1));
        assert_eq!((most - most).sign(), None);
        assert_eq!((BoundedWide::ZERO * most + least).sign(), Some(1));
    }
}
