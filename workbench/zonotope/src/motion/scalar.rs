//! Numbers of which polynomials in the time are made: doubles for guesses, doubles with a bound on their error for
//! decisions, exact ones where these are in doubt, and pairs of doubles for the last digits.
//!
//! The polynomials bound the *gap* of two bodies along a direction u: the least u · y over the second one's points,
//! less the largest u · x over the first one's. The *reach* of a body along u is Σ |u · g| over its generators, half
//! its extent.

use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::lanes::{absolute_sums, bounded_sums};
use crate::numeric::linear::{Ring, dot};

/// A number with a magnitude and a sign that may be in doubt.
pub(super) trait Scalar: Ring {
    /// A double as such a number.
    fn of(value: f64) -> Self;

    /// An exact number, or the nearest one there is.
    fn near(exact: &Dyadic) -> Self;

    /// The magnitude, with the same bound on its error.
    fn magnitude(&self) -> Self;

    /// Whether the exact value is greater than 0 beyond doubt.
    fn is_certainly_positive(&self) -> bool;
}

/// A number in which the reach of a body along a direction is computed.
pub(super) trait ReachScalar: Scalar {
    /// The largest of some numbers, of which there is at least one.
    fn largest(numbers: impl Iterator<Item = Self>) -> Self;

    /// Σ |u · g| over generators g for each of several directions u; `magnitude` is Σ |g|_1, but for rounding.
    fn reaches<const K: usize>(generators: &[[f64; 3]], magnitude: f64, directions: &[[Self; 3]; K]) -> [Self; K];
}

impl ReachScalar for f64 {
    fn largest(numbers: impl Iterator<Item = Self>) -> Self {
        numbers.fold(f64::NEG_INFINITY, f64::max)
    }

    fn reaches<const K: usize>(generators: &[[f64; 3]], _: f64, directions: &[[Self; 3]; K]) -> [Self; K] {
        absolute_sums(Rows::new(generators), directions)
    }
}

impl Scalar for f64 {
    #[inline]
    fn of(value: f64) -> Self {
        value
    }

    fn near(exact: &Dyadic) -> Self {
        exact.to_f64()
    }

    #[inline]
    fn magnitude(&self) -> Self {
        self.abs()
    }

    #[inline]
    fn is_certainly_positive(&self) -> bool {
        *self > 0.0
    }
}

impl ReachScalar for Bounded {
    /// The largest of the true numbers is at least the largest value less the largest error, and no more than both.
    fn largest(numbers: impl Iterator<Item = Self>) -> Self {
        let first = Self { value: f64::NEG_INFINITY, error: 0.0 };
        numbers.fold(first, |most, number| Self {
            value: most.value.max(number.value),
            // NaN is no bound and must stay
            error: if number.error > most.error || number.error.is_nan() { number.error } else { most.error },
        })
    }

    fn reaches<const K: usize>(generators: &[[f64; 3]], magnitude: f64, directions: &[[Self; 3]; K]) -> [Self; K] {
        bounded_sums(Rows::new(generators), magnitude, directions)
    }
}

impl Scalar for Bounded {
    #[inline]
    fn of(value: f64) -> Self {
        Self::exact(value)
    }

    fn near(exact: &Dyadic) -> Self {
        let value = exact.to_f64();
        let is_exact = value.is_finite() && Dyadic::from_f64(value) == *exact;
        Self { value, error: if is_exact { 0.0 } else { 4.0 * f64::EPSILON * value.abs() + f64::from_bits(1) } }
    }

    #[inline]
    fn magnitude(&self) -> Self {
        Self { value: self.value.abs(), error: self.error }
    }

    #[inline]
    fn is_certainly_positive(&self) -> bool {
        self.is_positive()
    }
}

impl ReachScalar for Dyadic {
    fn largest(numbers: impl Iterator<Item = Self>) -> Self {
        let larger = |most: Self, number: Self| if number.minus(&most).sign().is_gt() { number } else { most };
        numbers.reduce(larger).unwrap_or_else(Self::zero)
    }

    fn reaches<const K: usize>(generators: &[[f64; 3]], _: f64, directions: &[[Self; 3]; K]) -> [Self; K] {
        let reach = |u: &[Self; 3]| {
            generators.iter().map(|g| dot(u, &g.map(Self::of)).abs()).fold(Self::zero(), |sum, c| sum + c)
        };
        directions.each_ref().map(reach)
    }
}

impl Scalar for Dyadic {
    fn of(value: f64) -> Self {
        Self::from_f64(value)
    }

    fn near(exact: &Dyadic) -> Self {
        exact.clone()
    }

    fn magnitude(&self) -> Self {
        self.clone().abs()
    }

    fn is_certainly_positive(&self) -> bool {
        self.sign().is_gt()
    }
}

impl Scalar for BoundedDoubleDouble {
    fn of(value: f64) -> Self {
        Self::exact(value)
    }

    fn near(exact: &Dyadic) -> Self {
        Self::of(exact)
    }

    fn magnitude(&self) -> Self {
        self.abs()
    }

    fn is_certainly_positive(&self) -> bool {
        self.sign() == Some(1)
    }
}
