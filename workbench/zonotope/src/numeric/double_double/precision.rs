//! The precisions in which a sign is decided, each where the ones before leave a doubt: doubles with bounds, doubles
//! with an exponent of their own, pairs of doubles, exact numbers.

use std::cmp::Ordering;

use super::bounded::BoundedDoubleDouble;
use crate::numeric::bounded::Bounded;
use crate::numeric::bounded::wide::BoundedWide;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::Ring;

/// Numbers of one precision.
pub(crate) trait Precision: Ring {
    /// A finite double.
    fn of_double(value: f64) -> Self;
    /// The sum of two finite doubles, the second one no more than what rounding takes off the first.
    fn of_sum(parts: [f64; 2]) -> Self;
    /// An exact number.
    fn of(number: &Dyadic) -> Self;
    /// The sign of the exact value if it is certain; that of 0 is known of exact numbers alone.
    fn certain_sign(&self) -> Option<Ordering>;
}

impl Precision for Bounded {
    fn of_double(value: f64) -> Self {
        Self::exact(value)
    }

    fn of_sum([value, tail]: [f64; 2]) -> Self {
        Self { value, error: tail.abs() }
    }

    fn of(number: &Dyadic) -> Self {
        BoundedDoubleDouble::of(number).rounded()
    }

    fn certain_sign(&self) -> Option<Ordering> {
        self.sign().map(|sign| sign.cmp(&0))
    }
}

impl Precision for BoundedWide {
    fn of_double(value: f64) -> Self {
        Self::exact(value)
    }

    fn of_sum(parts: [f64; 2]) -> Self {
        Self::of_sum(parts)
    }

    fn of(number: &Dyadic) -> Self {
        Self::of(number)
    }

    fn certain_sign(&self) -> Option<Ordering> {
        self.sign().map(|sign| sign.cmp(&0))
    }
}

impl Precision for BoundedDoubleDouble {
    fn of_double(value: f64) -> Self {
        Self::exact(value)
    }

    fn of_sum([head, tail]: [f64; 2]) -> Self {
        Self::of_parts(head, tail, 0.0)
    }

    fn of(number: &Dyadic) -> Self {
        Self::of(number)
    }

    fn certain_sign(&self) -> Option<Ordering> {
        self.sign().map(|sign| sign.cmp(&0))
    }
}

impl Precision for Dyadic {
    fn of_double(value: f64) -> Self {
        Self::from_f64(value)
    }

    fn of_sum([head, tail]: [f64; 2]) -> Self {
        Self::from_f64(head) + Self::from_f64(tail)
    }

    fn of(number: &Dyadic) -> Self {
        number.clone()
    }

    fn certain_sign(&self) -> Option<Ordering> {
        Some(self.sign())
    }
}
