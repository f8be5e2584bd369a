//! The operations of numbers that products and determinants need. Numbers with bounds and pairs of doubles are rings
//! where they are defined, as they rest on products themselves.

use dashu_int::IBig;

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// Numbers that are added, subtracted and multiplied: exactly, or rounded as their type says.
///
/// Operands are references, as long integers are copied at a cost; of doubles the compiler makes values again.
pub(crate) trait Ring: Clone {
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// self + other.
    fn plus(&self, other: &Self) -> Self;
    /// self − other.
    fn minus(&self, other: &Self) -> Self;
    /// self · other.
    fn times(&self, other: &Self) -> Self;
    /// Whether the number is known to be 0, so that a product with it is left out.
    fn is_exactly_zero(&self) -> bool;
}

/// Numbers of a few words: their operators take values.
macro_rules! ring_of_values {
    ($number:ty, $zero:expr, $one:expr) => {
        impl $crate::numeric::linear::Ring for $number {
            const ZERO: Self = $zero;
            const ONE: Self = $one;
            #[inline(always)]
            fn plus(&self, other: &Self) -> Self {
                *self + *other
            }
            #[inline(always)]
            fn minus(&self, other: &Self) -> Self {
                *self - *other
            }
            #[inline(always)]
            fn times(&self, other: &Self) -> Self {
                *self * *other
            }
            #[inline(always)]
            fn is_exactly_zero(&self) -> bool {
                false
            }
        }
    };
}

pub(crate) use ring_of_values;

/// Numbers of any length: their operators take references, and a product with 0 is worth leaving out.
macro_rules! ring_of_long_numbers {
    ($number:ty, $zero:expr, $one:expr) => {
        impl Ring for $number {
            const ZERO: Self = $zero;
            const ONE: Self = $one;
            fn plus(&self, other: &Self) -> Self {
                self + other
            }
            fn minus(&self, other: &Self) -> Self {
                self - other
            }
            fn times(&self, other: &Self) -> Self {
                self * other
            }
            fn is_exactly_zero(&self) -> bool {
                self.is_zero()
            }
        }
    };
}

ring_of_values!(f64, 0.0, 1.0);
ring_of_long_numbers!(Dyadic, Dyadic::zero(), Dyadic::one());
ring_of_long_numbers!(Rational, Rational::ZERO, Rational::ONE);
ring_of_long_numbers!(IBig, IBig::ZERO, IBig::ONE);
