//! Lengths of vectors of whole numbers, between two proportions.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot};

use crate::exact::linear::{Vector, dot};
use crate::exact::proportion::Proportion;

/// Roots are as exact as this many bits.
const BITS: usize = 160;

/// By how much bounds of a length may differ whatever the length: 64 times the smallest double, since the smallest ones
/// have no places to be rounded to.
pub(crate) const COARSENESS: f64 = f64::from_bits(64);

/// A lower and an upper bound of the square root of a number that is not negative, equal where it is a square.
pub(crate) fn root(square: &IBig) -> [Proportion; 2] {
    let shift = (2 * BITS).saturating_sub(square.bit_len()).div_ceil(2);
    let scaled: IBig = square << (2 * shift);
    let low = IBig::from(scaled.sqrt());
    let high = if &low * &low == scaled { low.clone() } else { &low + IBig::ONE };
    let exponent = -i32::try_from(shift).expect("the shift is at most the number of bits of a root");
    [low, high].map(|bound| Proportion::whole(bound, exponent))
}

/// A lower and an upper bound of the sum of the lengths.
pub(crate) fn total_length(vectors: &[Vector]) -> [Proportion; 2] {
    let zero = || Proportion::whole(IBig::ZERO, 0);
    vectors.iter().fold([zero(), zero()], |[low, high], vector| {
        let [shorter, longer] = root(&dot(vector, vector));
        [low.plus(&shorter), high.plus(&longer)]
    })
}

/// A length that is known by its square, which is not negative.
#[derive(Debug, Clone)]
pub(crate) struct Length {
    square: Proportion,
}

impl Length {
    /// The length with this square.
    pub(crate) fn of_square(square: Proportion) -> Self {
        Self { square }
    }

    /// The quotient along / |u|, which is not negative; `None` if u is zero.
    pub(crate) fn along(along: &Proportion, u: &[IBig]) -> Option<Self> {
        let square = along.times(along).over(&Proportion::whole(dot(u, u), 0))?;
        Some(Self { square })
    }

    /// Exact comparison with a number, without any root.
    pub(crate) fn compare(&self, number: &Proportion) -> Ordering {
        if number.is_negative() { Ordering::Greater } else { self.square.compare(&number.times(number)) }
    }

    /// Exact comparison of two lengths.
    pub(crate) fn compare_length(&self, other: &Self) -> Ordering {
        self.square.compare(&other.square)
    }

    /// The length in units 2^exponent, rounded for a message.
    pub(crate) fn rounded_at(&self, exponent: i32) -> f64 {
        self.square.root().times(&Proportion::whole(IBig::ONE, exponent)).nearest()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_by_hand() {
        let [low, high] = root(&IBig::from(144));
        let twelve = Proportion::of_double(12.0);
        assert_eq!((low.compare(&twelve), high.compare(&twelve)), (Ordering::Equal, Ordering::Equal));
        let two = Proportion::of_double(2.0);
        let [low, high] = root(&IBig::from(2));
        assert_eq!(low.times(&low).compare(&two), Ordering::Less);
        assert_eq!(high.times(&high).compare(&two), Ordering::Greater);
        assert_eq!(high.minus(&low).nearest(), 2.0_f64.powi(-159));
        let [low, high] =
            total_length(&[vec![3.into(), 4.into()], vec![0.into(), (-7).into()], vec![0.into(), 0.into()]]);
        assert_eq!((low.nearest(), high.nearest()), (12.0, 12.0));
    }

    #[test]
    fn lengths_are_compared_by_their_squares() {
        let diagonal = Length::along(&Proportion::whole(2.into(), 0), &[1.into(), 1.into()]).expect("not zero");
        let root = 2.0_f64.sqrt();
        assert_eq!(diagonal.compare(&Proportion::of_double(root)), Ordering::Less, "the double is above the root");
        assert_eq!(diagonal.compare(&Proportion::of_double(root.next_down())), Ordering::Greater);
        assert_eq!(diagonal.compare(&Proportion::of_double(-root)), Ordering::Greater);
        let five = Length::of_square(Proportion::whole(25.into(), 0));
        assert_eq!(five.compare(&Proportion::of_double(5.0)), Ordering::Equal);
        assert_eq!((five.compare_length(&diagonal), diagonal.rounded_at(0)), (Ordering::Greater, root));
        assert!(Length::along(&Proportion::whole(2.into(), 0), &[IBig::ZERO]).is_none());
    }
}
