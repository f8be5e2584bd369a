//! The square root of an exact fraction between two neighbouring doubles, and the double nearest to it.

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot, UnsignedAbs};

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::outward::{at_least, at_most};
use crate::numeric::scaling::power_of_two;

/// Bits of a root beyond which only the question is left whether it has more.
const ROOT_BITS: usize = 80;

/// A root, rounded in three ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Root {
    /// The greatest double that is not above it.
    pub(crate) below: f64,
    /// The nearest double; infinite where the exact value is nearer to 2^1024 than to the largest double.
    pub(crate) nearest: f64,
    /// The least double that is not below it; infinite above the largest double.
    pub(crate) above: f64,
}

impl Root {
    /// The root of `square` · 4^`exponent`, of a square that is not negative.
    pub(crate) fn of(square: &Rational, exponent: i64) -> Self {
        let (numerator, denominator) = (square.numerator(), IBig::from(square.denominator().clone()));
        let wanted = 2 * ROOT_BITS + denominator.bit_len();
        let shift = wanted.saturating_sub(numerator.bit_len()).div_ceil(2);
        let scaled: IBig = numerator << (2 * shift);
        let quotient = &scaled / &denominator;
        let root = IBig::from(quotient.unsigned_abs().sqrt());
        let is_exact = &root * &root * &denominator == scaled;
        let unit = exponent - shift as i64;
        let low = Dyadic::new(root.clone(), unit);
        if is_exact {
            let (below, above) = (at_most(&low), at_least(&low));
            return Self { below, nearest: nearer(below, &low, above), above };
        }
        // the root lies strictly between two neighbours of so many bits that no double and no middle of two is there
        let between = Dyadic::new((root.clone() << 1) + IBig::ONE, unit - 1);
        let (below, above) = (at_most(&low), at_least(&Dyadic::new(root + IBig::ONE, unit)));
        Self { below, nearest: nearer(below, &between, above), above }
    }
}

/// Of two neighbouring doubles the one that is nearer to a number between them; the upper one of two equally near.
fn nearer(below: f64, exact: &Dyadic, above: f64) -> f64 {
    let end = || Dyadic::from_f64(power_of_two(1023)).scaled(1);
    let upper = if above.is_finite() { Dyadic::from_f64(above) } else { end() };
    let twice = exact.clone().scaled(1);
    if twice < Dyadic::from_f64(below) + upper { below } else { above }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of(square: Dyadic) -> Root {
        Root::of(&square.to_rational(), 0)
    }

    #[test]
    fn roots_by_hand() {
        let double = |v: f64| Dyadic::from_f64(v);
        assert_eq!(of(double(9.0)), Root { below: 3.0, nearest: 3.0, above: 3.0 });
        assert_eq!(of(Dyadic::zero()), Root { below: 0.0, nearest: 0.0, above: 0.0 });
        let root = 3f64.sqrt();
        assert_eq!(of(double(3.0)), Root { below: root, nearest: root, above: root.next_up() });
        let third = Rational::from_parts(1.into(), 9u8.into());
        assert_eq!(Root::of(&third, 0).nearest, 1.0 / 3.0);
        assert_eq!(Root::of(&third, 3).nearest, 8.0 / 3.0);
        let least = f64::from_bits(1);
        assert_eq!(of(double(least) * double(least)), Root { below: least, nearest: least, above: least });
        let (largest, infinite) = (f64::MAX, f64::INFINITY);
        let two_of = double(largest) * double(largest).scaled(1);
        assert_eq!(of(two_of), Root { below: largest, nearest: infinite, above: infinite });
        let a_bit_more = double(largest) + double(1.0);
        assert_eq!(of(&a_bit_more * &a_bit_more), Root { below: largest, nearest: largest, above: infinite });
    }

    properties! {
        #[test]
        fn a_root_is_enclosed_and_rounded(a in any::<u64>(), b in 1..u64::MAX, exponent in -1100i64..1000) {
            let square = Rational::from_parts(a.into(), b.into());
            let root = Root::of(&square, exponent);
            let squared = |value: &Dyadic| (value * value).scaled(-2 * exponent).to_rational();
            let [below, above] = [root.below, root.above].map(Dyadic::from_f64);
            prop_assert!(squared(&below) <= square && square <= squared(&above));
            prop_assert!(root.below == root.above || root.below.next_up() == root.above);
            let is_lower = squared(&(below + above).scaled(-1)) > square;
            prop_assert_eq!(root.nearest, if is_lower { root.below } else { root.above });
        }
    }

    #[test]
    fn roots_beside_a_double_and_beside_the_middle_of_two_are_told_from_these() {
        let one_and = |exponent: i64| Dyadic::one() + Dyadic::one().scaled(exponent);
        let (low, high) = (1.0, 1f64.next_up());
        let middle = one_and(-53);
        let square = &middle * &middle;
        let bit = Dyadic::one().scaled(-120);
        assert_eq!(of(square.clone()), Root { below: low, nearest: high, above: high });
        assert_eq!(of(&square + &bit), Root { below: low, nearest: high, above: high });
        assert_eq!(of(&square - &bit), Root { below: low, nearest: low, above: high });
        assert_eq!(of(one_and(-120)), Root { below: low, nearest: low, above: high });
    }
}
