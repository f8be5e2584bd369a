//! Doubles with a bound on their distance from an exact value, for filters of a few operations.
//!
//! Each operation adds its own rounding: u = 2^-53 times the result, and less than 2^-900 for underflow. The bounds
//! themselves are sums and products of a few rounded terms that are not negative, which [`FIVE_ROUNDINGS`] covers.
//! Overflow makes a bound infinite or NaN, and every certain comparison false.

pub(crate) mod wide;

use std::ops::{Add, Mul, Sub};

use super::dyadic::Dyadic;
use super::exact_sum::exact_sum;
use super::linear::{self, ring_of_values};
use super::tolerance::{DIFFERENCE_OF_LEADING_DOUBLES, FIVE_ROUNDINGS, PRODUCT_UNDERFLOW, UNIT};

/// An exact value within `error` of `value`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounded {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// A vector of such values.
pub(crate) type BoundedVector = [Bounded; 3];

impl Bounded {
    /// A double that is the exact value.
    #[inline]
    pub(crate) const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// Whether the exact value is certainly positive.
    #[inline]
    pub(crate) fn is_positive(self) -> bool {
        self.value > self.error
    }

    /// Whether the exact value is certainly smaller in magnitude than another, which is certainly positive.
    #[inline]
    pub(crate) fn is_within(self, limit: Self) -> bool {
        (self.value.abs() + self.error) * FIVE_ROUNDINGS < (limit.value - limit.error) * (2.0 - FIVE_ROUNDINGS)
    }

    /// The sign of the exact value if it is certain and not zero.
    #[inline]
    pub(crate) fn sign(self) -> Option<i8> {
        (self.value.abs() > self.error).then_some(if self.value > 0.0 { 1 } else { -1 })
    }

    /// A bound for the exact value's magnitude.
    #[inline]
    pub(crate) fn magnitude(self) -> f64 {
        (self.value.abs() + self.error) * FIVE_ROUNDINGS
    }

    /// The opposite value.
    #[inline]
    pub(crate) fn negated(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl Add for Bounded {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self { value, error: (self.error + other.error + UNIT * value.abs()) * FIVE_ROUNDINGS }
    }
}

impl Sub for Bounded {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        let value = self.value - other.value;
        Self { value, error: (self.error + other.error + UNIT * value.abs()) * FIVE_ROUNDINGS }
    }
}

impl Mul for Bounded {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let carried = self.value.abs() * other.error + (other.value.abs() + other.error) * self.error;
        Self { value, error: (carried + UNIT * value.abs()) * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW }
    }
}

ring_of_values!(Bounded, Bounded::exact(0.0), Bounded::exact(1.0));

/// A vector of doubles.
#[inline]
pub(crate) fn exact(v: [f64; 3]) -> BoundedVector {
    v.map(Bounded::exact)
}

/// A vector of exact numbers, as its leading doubles.
pub(crate) fn leading(v: &[Dyadic; 3]) -> BoundedVector {
    v.each_ref().map(|coordinate| {
        let value = coordinate.to_f64();
        Bounded { value, error: DIFFERENCE_OF_LEADING_DOUBLES * value.abs() + f64::MIN_POSITIVE }
    })
}

/// A vector that is known but for a part of its length.
pub(crate) fn approximate(v: [f64; 3], relative_error: f64) -> BoundedVector {
    if relative_error == 0.0 {
        return exact(v);
    }
    let error = 2.0 * relative_error * v.iter().map(|c| c.abs()).sum::<f64>();
    v.map(|value| Bounded { value, error })
}

/// The difference `to` − `from` of two vectors of doubles.
#[inline]
pub(crate) fn difference(from: [f64; 3], to: [f64; 3]) -> BoundedVector {
    let difference = |i: usize| {
        let (value, rest) = exact_sum(to[i], -from[i]);
        Bounded { value, error: if rest == 0.0 { 0.0 } else { UNIT * value.abs() } }
    };
    [difference(0), difference(1), difference(2)]
}

/// a × b.
///
/// Of vectors of doubles the bound is that of six products and three differences, which takes half the operations of
/// the bound that carries errors of the coordinates on.
#[inline]
pub(crate) fn cross(a: &BoundedVector, b: &BoundedVector) -> BoundedVector {
    if a.iter().chain(b).any(|c| c.error != 0.0) {
        return linear::cross(a, b);
    }
    let minor = |i: usize, j: usize| {
        let (first, second) = (a[i].value * b[j].value, a[j].value * b[i].value);
        let value = first - second;
        let error = UNIT * (first.abs() + second.abs() + value.abs());
        Bounded { value, error: error * FIVE_ROUNDINGS + 2.0 * PRODUCT_UNDERFLOW }
    };
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// A bound as it is, infinite where it is NaN.
pub(crate) fn finite_or_infinity(bound: f64) -> f64 {
    if bound.is_finite() { bound } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear;
    use crate::numeric::linear::dot;
    use proptest::prelude::*;

    properties! {
        #[test]
        fn bounds_hold(bits in proptest::array::uniform9(any::<u64>()), small in any::<bool>()) {
            let value = |bits: u64| {
                let v = f64::from_bits(bits);
                if !v.is_finite() { 0.5 } else if small { v % 8.0 } else { v }
            };
            let rows: [[f64; 3]; 3] = [0, 3, 6].map(|i| [0, 1, 2].map(|k| value(bits[i + k])));
            let [a, b, c] = rows.map(exact);
            let rounded = dot(&cross(&a, &b), &c);
            let [a, b, c] = rows.map(exact_linear::exact);
            let truth = dot(&exact_linear::cross(&a, &b), &c);
            if rounded.error.is_finite() && rounded.value.is_finite() {
                let off = (truth.clone() - Dyadic::from_f64(rounded.value)).abs();
                prop_assert!(off <= Dyadic::from_f64(rounded.error));
                if let Some(sign) = rounded.sign() {
                    prop_assert_eq!(sign, truth.sign() as i8);
                }
            }
        }
    }
}
