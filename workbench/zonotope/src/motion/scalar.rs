//! Numbers of which a bound of a gap is made: doubles for guesses, doubles with a bound on their error for decisions,
//! exact ones where these are in doubt.

use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::Ring;

/// A number with a magnitude and a sign that may be in doubt.
pub(super) trait Scalar: Ring {
    /// A double as such a number.
    fn of(value: f64) -> Self;

    /// An exact number, or the nearest one there is.
    fn near(exact: &Dyadic) -> Self;

    /// The magnitude, or more where the sign is in doubt.
    fn magnitude(&self) -> Self;

    /// Whether the exact value is greater than 0 beyond doubt.
    fn is_certainly_positive(&self) -> bool;
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
        false
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
