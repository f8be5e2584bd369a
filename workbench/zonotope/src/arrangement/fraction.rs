//! Exact quotients of dyadic numbers, unreduced: slopes, heights and abscissas of lines.

use std::cmp::Ordering;

use crate::numeric::Rational;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::DIFFERENCE_OF_LEADING_DOUBLES;

/// Exponents that differ by this much or more leave no doubt which of two magnitudes is larger.
const DECISIVE_EXPONENT_GAP: i64 = 60;

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
    pub(crate) fn approximate(&self, shift: i64) -> BoundedDoubleDouble {
        BoundedDoubleDouble::of_ratio(&self.numerator.clone().scaled(shift), &self.denominator)
    }

    /// The order where the leading doubles tell.
    fn certain_order(&self, other: &Self) -> Option<Ordering> {
        let (Some((e, own)), Some((f, others))) = (self.leading(), other.leading()) else {
            return Some(self.numerator.sign().cmp(&other.numerator.sign()));
        };
        // both are about 1: what is far apart stays far apart
        let own = scale_by_power_of_two(own, (e - f).clamp(-DECISIVE_EXPONENT_GAP, DECISIVE_EXPONENT_GAP));
        let difference = own - others;
        (difference.abs() > DIFFERENCE_OF_LEADING_DOUBLES * (own.abs() + others.abs()))
            .then(|| difference.total_cmp(&0.0))
    }

    pub(crate) fn to_rational(&self) -> Rational {
        self.numerator.to_rational() / self.denominator.to_rational()
    }

    /// The nearest double but for a relative 2^-50.
    pub(crate) fn to_f64(&self) -> f64 {
        self.numerator.ratio(&self.denominator)
    }

    /// An exponent and what is left of the value, with its sign, of magnitude in [1, 2) and within a relative 2^-50;
    /// none for zero. However far out of the range of doubles.
    pub(crate) fn leading(&self) -> Option<(i64, f64)> {
        let ((head, e), (other, f)) = (self.numerator.leading(), self.denominator.leading());
        let exponent = i64::from(binary_exponent(head / other)?);
        Some((exponent + e - f, scale_by_power_of_two(head / other, -exponent)))
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
        self.certain_order(other)
            .unwrap_or_else(|| (&self.numerator * &other.denominator).cmp(&(&other.numerator * &self.denominator)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value() -> impl Strategy<Value = f64> {
        prop_oneof![
            2 => -4.0..4.0f64,
            2 => (-3i32..4).prop_map(f64::from),
            1 => -1e300..1e300f64,
            1 => (-3i32..4).prop_map(|i| f64::from(i) * f64::from_bits(1)),
        ]
    }

    fn fraction() -> impl Strategy<Value = Fraction> {
        let positive = value().prop_map(|v| if v == 0.0 { 1.0 } else { v });
        (value(), positive).prop_map(|(n, d)| Fraction::new(Dyadic::from_f64(n), Dyadic::from_f64(d)))
    }

    properties! {
        #![proptest_config(crate::property_cases::config(2000))]

        #[test]
        fn the_order_is_that_of_the_rationals(a in fraction(), b in fraction()) {
            prop_assert_eq!(a.cmp(&b), a.to_rational().cmp(&b.to_rational()));
            match a.leading() {
                None => prop_assert!(a.numerator.is_zero()),
                Some((exponent, rest)) => {
                    prop_assert!((1.0..2.0).contains(&rest.abs()));
                    let near = Dyadic::from_f64(rest).scaled(exponent).to_rational();
                    let (off, size) = (&near - a.to_rational(), Dyadic::from_f64(2f64.powi(-50)).to_rational() * &near);
                    prop_assert!(&off * &off <= &size * &size);
                }
            }
        }
    }
}
