//! Exact quotients of dyadic numbers, unreduced: slopes, heights and abscissas of lines.

use std::cmp::Ordering;

use crate::numeric::Rational;
use crate::numeric::approximation::Approximation;
use crate::numeric::dyadic::Dyadic;

/// numerator / denominator with a positive denominator.
#[derive(Debug, Clone)]
pub(crate) struct Fraction {
    pub(crate) numerator: Dyadic,
    pub(crate) denominator: Dyadic,
}

impl Fraction {
    /// The quotient of two numbers, the second not zero.
    pub(crate) fn new(numerator: Dyadic, denominator: Dyadic) -> Self {
        match denominator.sign() {
            Ordering::Greater => Self { numerator, denominator },
            Ordering::Less => Self { numerator: -numerator, denominator: -denominator },
            Ordering::Equal => unreachable!("a fraction has a denominator other than zero"),
        }
    }

    /// The fraction times 2^shift, approximately.
    pub(crate) fn approximate(&self, shift: i64) -> Approximation {
        Approximation::of_ratio(&self.numerator.clone().scaled(shift), &self.denominator)
    }

    pub(crate) fn to_rational(&self) -> Rational {
        self.numerator.to_rational() / self.denominator.to_rational()
    }

    /// The nearest double but for a relative 2^-50.
    pub(crate) fn to_f64(&self) -> f64 {
        self.numerator.ratio(&self.denominator)
    }

    /// The exponent of the binary magnitude, within 1; `None` for zero.
    pub(crate) fn binary_exponent(&self) -> Option<i64> {
        Some(self.numerator.binary_exponent()? - self.denominator.binary_exponent()?)
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Fraction {}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Fraction {
    fn cmp(&self, other: &Self) -> Ordering {
        (&self.numerator * &other.denominator).cmp(&(&other.numerator * &self.denominator))
    }
}
