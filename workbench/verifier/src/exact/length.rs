//! Lengths of vectors of whole numbers, between two proportions.

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot};

use crate::exact::linear::{Vector, dot};
use crate::exact::proportion::Proportion;

/// Roots are as exact as this many bits.
const BITS: usize = 160;

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

#[cfg(test)]
mod tests {
    use super::*;
    use std::cmp::Ordering;

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
}
