//! A real number as a sum of two doubles within a known error: about 98 bits, for what one double cannot tell apart.
//!
//! Values that nearly agree (the heights of lines that almost pass through one point) need more than the 53 bits of a
//! double, yet rarely exact arithmetic. Each operation here carries a bound on the distance from the exact value, so a
//! comparison knows whether it is certain. Overflow and division by what may be zero give a value of which nothing is
//! known.
//!
//! Bounds: with u = 2^-53, the sum, product and quotient of two doubles-pairs below have a relative error of at most 16
//! u² of the sum of the operands' magnitudes (sum) or of the result (product, quotient), plus less than 2^-1060 for
//! underflow; [`DOUBLE_DOUBLE_OPERATION`] and [`UNDERFLOW`] are above both, with room for the rounding of the bounds
//! themselves.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Sub};

use super::plain::DoubleDouble;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::linear::ring_of_values;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::numeric::tolerance::{DOUBLE_DOUBLE_BOUND, DOUBLE_DOUBLE_OPERATION, UNDERFLOW, UNIT};

/// A value scaled down by more than this power of two is only an error.
const VANISHING: i64 = -900;

/// The exact value lies within `error` of `high` + `low`; |low| ≤ u |high|.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BoundedDoubleDouble {
    pub(crate) high: f64,
    low: f64,
    error: f64,
}

impl BoundedDoubleDouble {
    /// A double.
    pub(crate) const fn exact(value: f64) -> Self {
        Self { high: value, low: 0.0, error: 0.0 }
    }

    /// The sum of two doubles, of which it is known how far it is off.
    pub(crate) fn of_parts(head: f64, tail: f64, error: f64) -> Self {
        let (high, low) = exact_sum(head, tail);
        Self::within(DoubleDouble { high, low }, error)
    }

    /// The two doubles, and how far they are off.
    pub(crate) fn parts(&self) -> (DoubleDouble, f64) {
        (self.pair(), self.error)
    }

    /// An exact number.
    pub(crate) fn of(number: &Dyadic) -> Self {
        let head = number.to_f64();
        if !head.is_finite() {
            return Self::unknown();
        }
        let pair = DoubleDouble::ordered_sum(head, (number - &Dyadic::from_f64(head)).to_f64());
        Self::within(pair, DOUBLE_DOUBLE_OPERATION * pair.high.abs() + UNDERFLOW)
    }

    /// The sign of the exact value if it is certain and not zero.
    pub(crate) fn sign(&self) -> Option<i8> {
        let is_certain = self.high.abs() * (1.0 - 4.0 * UNIT) > self.error * DOUBLE_DOUBLE_BOUND;
        is_certain.then_some(if self.high > 0.0 { 1 } else { -1 })
    }

    /// The quotient of two exact numbers, the divisor positive.
    pub(crate) fn of_ratio(numerator: &Dyadic, denominator: &Dyadic) -> Self {
        let head = numerator.ratio(denominator);
        if !head.is_finite() {
            return Self::unknown();
        }
        let rest = numerator - &(&Dyadic::from_f64(head) * denominator);
        let pair = DoubleDouble::ordered_sum(head, rest.ratio(denominator));
        Self::within(pair, DOUBLE_DOUBLE_OPERATION * pair.high.abs() + UNDERFLOW)
    }

    /// The double nearest to the exact value, if the bounds tell which one it is.
    pub(crate) fn nearest_double(&self) -> Option<f64> {
        let reach = (self.low.abs() + self.error) * DOUBLE_DOUBLE_BOUND;
        let is_near = self.high + reach == self.high && self.high - reach == self.high;
        // Without an error the larger double is the rounded sum, also where that lies midway between two doubles.
        (is_near || self.error == 0.0).then_some(self.high)
    }

    /// Whether the exact value is certainly not a double: it is strictly between `high` and the next one.
    pub(crate) fn is_no_double(&self) -> bool {
        self.low.abs() > self.error * DOUBLE_DOUBLE_BOUND && self.nearest_double().is_some()
    }

    /// Whether there is a bound on the error.
    pub(crate) fn is_known(&self) -> bool {
        self.error < f64::INFINITY
    }

    /// The sum of the two doubles, exactly.
    pub(crate) fn to_dyadic(self) -> Dyadic {
        Dyadic::from_f64(self.high) + Dyadic::from_f64(self.low)
    }

    /// Whether the exact value is known to be the double `high`.
    pub(crate) fn is_exactly_double(&self) -> bool {
        self.low == 0.0 && self.error == 0.0
    }

    /// The opposite value.
    pub(crate) fn negated(self) -> Self {
        Self { high: -self.high, low: -self.low, ..self }
    }

    /// A double that the absolute value does not exceed.
    pub(crate) fn largest(self) -> Self {
        Self::within(DoubleDouble::from((self.high.abs() + self.low.abs() + self.error) * DOUBLE_DOUBLE_BOUND), 0.0)
    }

    /// The absolute value.
    pub(crate) fn abs(self) -> Self {
        if self.high < 0.0 { self.negated() } else { self }
    }

    /// The value times a power of two; a value near zero where the exponent is below [`VANISHING`].
    pub(crate) fn scaled(self, exponent: i64) -> Self {
        let factor = scale_by_power_of_two(1.0, exponent.max(VANISHING));
        if exponent < VANISHING {
            return Self::within(DoubleDouble::from(0.0), 2.0 * (self.high.abs() + self.error) * factor + UNDERFLOW);
        }
        let pair = DoubleDouble { high: self.high * factor, low: self.low * factor };
        Self::within(pair, self.error * factor + UNDERFLOW)
    }

    /// The order of the exact values, if the bounds decide it.
    pub(crate) fn certain_order(&self, other: &Self) -> Option<Ordering> {
        let (high, low) = (self.high - other.high, self.low - other.low);
        let difference = high + low;
        let bound = (self.error + other.error + 4.0 * UNIT * (high.abs() + low.abs())) * DOUBLE_DOUBLE_BOUND;
        (difference.abs() > bound).then(|| difference.total_cmp(&0.0))
    }

    /// One double, with a bound on its distance from the exact value.
    pub(crate) fn rounded(&self) -> Bounded {
        Bounded { value: self.high, error: (self.low.abs() + self.error) * DOUBLE_DOUBLE_BOUND }
    }

    /// Doubles between which the exact value lies.
    pub(crate) fn interval(&self) -> (f64, f64) {
        let reach = (self.low.abs() + self.error + 2.0 * UNIT * self.high.abs()) * DOUBLE_DOUBLE_BOUND;
        if reach < f64::INFINITY { (self.high - reach, self.high + reach) } else { (f64::NEG_INFINITY, f64::INFINITY) }
    }

    fn unknown() -> Self {
        Self { high: f64::NAN, low: 0.0, error: f64::INFINITY }
    }

    fn pair(&self) -> DoubleDouble {
        DoubleDouble { high: self.high, low: self.low }
    }

    fn plus(self, other: Self) -> Self {
        let rounding = DOUBLE_DOUBLE_OPERATION * (self.high.abs() + other.high.abs());
        Self::within(self.pair() + other.pair(), self.error + other.error + rounding)
    }

    fn within(DoubleDouble { high, low }: DoubleDouble, error: f64) -> Self {
        let error = error * DOUBLE_DOUBLE_BOUND;
        if high.is_finite() && low.is_finite() && error < f64::INFINITY {
            Self { high, low, error }
        } else {
            Self::unknown()
        }
    }
}

impl Add for BoundedDoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl Sub for BoundedDoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.plus(other.negated())
    }
}

impl Mul for BoundedDoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = self.pair() * other.pair();
        let carried = self.high.abs() * other.error + other.high.abs() * self.error + self.error * other.error;
        Self::within(product, carried + DOUBLE_DOUBLE_OPERATION * product.high.abs() + UNDERFLOW)
    }
}

impl Div for BoundedDoubleDouble {
    type Output = Self;
    fn div(self, divisor: Self) -> Self {
        let least = divisor.high.abs() * (1.0 - 8.0 * UNIT) - divisor.error * DOUBLE_DOUBLE_BOUND;
        if least.is_nan() || least <= 0.0 {
            return Self::unknown();
        }
        let quotient = self.pair() / divisor.pair();
        let carried = (self.error + quotient.high.abs() * divisor.error + UNDERFLOW) / least;
        Self::within(
            quotient,
            carried * DOUBLE_DOUBLE_BOUND + DOUBLE_DOUBLE_OPERATION * quotient.high.abs() + UNDERFLOW,
        )
    }
}

ring_of_values!(BoundedDoubleDouble, BoundedDoubleDouble::exact(0.0), BoundedDoubleDouble::exact(1.0));

#[cfg(test)]
mod tests;
