//! The sum of two doubles as one number: about 104 bits, within the range of doubles.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::numeric::exact_product::exact_product;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::linear::ring_of_values;

/// `high` + `low`, |low| ≤ u |high|. With u = 2^-53 sums are within 16 u² of the operands' magnitudes, products,
/// quotients and roots within 16 u² of themselves, but for underflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DoubleDouble {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

impl DoubleDouble {
    /// a + b, |a| ≥ |b| or a = 0.
    #[inline]
    pub(crate) fn ordered_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self { high, low: b - (high - a) }
    }

    pub(crate) fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 || !root.is_finite() {
            return Self::from(root);
        }
        let (square, error) = exact_product(root, root);
        let rest = self - Self { high: square, low: error };
        Self::ordered_sum(root, rest.high / (2.0 * root))
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl PartialOrd for DoubleDouble {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            order => order,
        }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let (sum, error) = exact_sum(self.high, other.high);
        Self::ordered_sum(sum, error + (self.low + other.low))
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (product, error) = exact_product(self.high, other.high);
        Self::ordered_sum(product, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline]
    fn div(self, divisor: Self) -> Self {
        let head = self.high / divisor.high;
        let rest = self - Self::from(head) * divisor;
        Self::ordered_sum(head, rest.high / divisor.high)
    }
}

ring_of_values!(DoubleDouble, DoubleDouble { high: 0.0, low: 0.0 }, DoubleDouble { high: 1.0, low: 0.0 });

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Rational;
    use crate::numeric::dyadic::Dyadic;
    use proptest::prelude::*;

    fn exact(pair: DoubleDouble) -> Rational {
        Dyadic::from_f64(pair.high).to_rational() + Dyadic::from_f64(pair.low).to_rational()
    }

    fn number() -> impl Strategy<Value = DoubleDouble> {
        let high = prop_oneof![-1.0..1.0f64, -1e9..1e9f64, (-3i32..4).prop_map(f64::from)];
        (high, -1.0..1.0f64).prop_map(|(high, part)| DoubleDouble::ordered_sum(high, high * part * f64::EPSILON))
    }

    /// Whether a result is within 16 u² of a size.
    fn near(result: DoubleDouble, truth: &Rational, size: &Rational) -> bool {
        let allowed = size * Dyadic::from_f64(f64::EPSILON * f64::EPSILON * 4.0).to_rational();
        let off = exact(result) - truth;
        off <= allowed && -off <= allowed
    }

    fn magnitude(value: &Rational) -> Rational {
        if *value < Rational::ZERO { -value.clone() } else { value.clone() }
    }

    properties! {
        #![proptest_config(crate::property_cases::config(2000))]

        #[test]
        fn operations_are_good_to_104_bits(a in number(), b in number()) {
            let (x, y) = (exact(a), exact(b));
            let sizes = magnitude(&x) + magnitude(&y);
            prop_assert!(near(a + b, &(&x + &y), &sizes));
            prop_assert!(near(a - b, &(&x - &y), &sizes));
            let product = &x * &y;
            prop_assert!(near(a * b, &product, &magnitude(&product)));
            if b.high != 0.0 {
                let quotient = &x / &y;
                prop_assert!(near(a / b, &quotient, &magnitude(&quotient)));
            }
            let square = a * a;
            let (root, size) = (square.sqrt(), magnitude(&x));
            // (root − |x|) (root + |x|) = root² − x²
            prop_assert!(near(root, &size, &(&size + &size)), "{:?} {:?}", root, a);
            prop_assert_eq!(a.partial_cmp(&b), x.partial_cmp(&y));
        }
    }
}
