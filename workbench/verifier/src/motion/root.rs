//! Roots of whole numbers, rounded up.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

/// The places after the point of the roots.
pub(super) const ROOT_PLACES: usize = 32;

/// The bits of the number of which a root is taken, an even number.
const ROOT_BITS: usize = 126;

/// At least the root of a number that is not negative, in units of 2^-[`ROOT_PLACES`]: above it by less than 2^-60 of
/// it and a unit.
pub(super) fn root_above(square: &IBig) -> IBig {
    if *square <= IBig::ZERO {
        return IBig::ZERO;
    }
    let fine = square << (2 * ROOT_PLACES);
    let dropped = fine.bit_len().saturating_sub(ROOT_BITS).next_multiple_of(2);
    let kept = u128::try_from(fine >> dropped).unwrap_or(u128::MAX >> 1);
    // The part that is dropped is less than 1.
    IBig::from((kept + 1).isqrt() + 1) << (dropped / 2)
}

/// The quotient of two positive numbers, rounded up.
pub(super) fn quotient_above(numerator: &IBig, denominator: &IBig) -> IBig {
    (numerator + denominator - IBig::ONE) / denominator
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_rounded_up_by_little() {
        for number in [1_u32, 2, 3, 4, 99, 1 << 31] {
            for shift in [0_usize, 1, 40, 200, 901] {
                let square = IBig::from(number) << shift;
                let root = root_above(&square);
                let exact = &square << (2 * ROOT_PLACES);
                assert!(&root * &root >= exact, "{number} {shift}");
                let less = &root - (&root >> 59_usize) - IBig::from(2);
                assert!(&less * &less < exact, "{number} {shift}");
            }
        }
        assert_eq!(root_above(&IBig::ZERO), IBig::ZERO);
        assert_eq!(quotient_above(&IBig::from(7), &IBig::from(2)), IBig::from(4));
        assert_eq!(quotient_above(&IBig::from(6), &IBig::from(2)), IBig::from(3));
    }

    #[test]
    fn a_root_is_above_the_exact_one_where_a_little_is_dropped() {
        // The bits that are kept of 2^200 + 1 are those of 2^200.
        let square = (IBig::ONE << 200_usize) + IBig::ONE;
        let root = root_above(&square);
        assert!(&root * &root > square << (2 * ROOT_PLACES));
        // A unit is left for what is dropped, even where that is nothing: (2^63 - 1)² - 1 is 2^64 (2^62 - 1).
        assert_eq!(root_above(&((IBig::ONE << 62_usize) - IBig::ONE)), IBig::ONE << 63_usize);
    }
}
