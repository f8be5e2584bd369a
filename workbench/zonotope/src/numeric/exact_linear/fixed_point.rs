//! Sums of doubles, and of such sums times doubles, in fixed point: integers of so many words in units of a power of
//! two.
//!
//! A [`Dyadic`] is allocated anew by every operation and finds its size anew. Where it is known beforehand how large
//! and how fine a sum becomes, its words stay where they are, and a step is one pass over them.

use dashu_int::{IBig, UBig};

use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, decompose};

/// The exponents of the largest and of the smallest bit that doubles may have, with room for sums of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct BitRange {
    pub(crate) lowest: i64,
    pub(crate) highest: i64,
}

impl BitRange {
    /// The range that holds a sum of so many of these doubles or fewer, and its negative.
    pub(crate) fn of_sums(terms: impl IntoIterator<Item = f64>, count: usize) -> Self {
        let (mut lowest, mut highest) = (i64::MAX, i64::MIN);
        for term in terms.into_iter().filter(|term| *term != 0.0) {
            lowest = lowest.min(i64::from(decompose(term).1));
            highest = highest.max(binary_exponent(term).map_or(0, i64::from));
        }
        if lowest > highest {
            return Self { lowest: 0, highest: 0 };
        }
        // |term| < 2^(highest + 1), and a bit for the sign
        Self { lowest, highest: highest + 2 + bits_of(count) }
    }

    /// The range that holds a sum of so many products of a number of this range and one of the other.
    pub(crate) fn of_products(self, other: Self, count: usize) -> Self {
        Self { lowest: self.lowest + other.lowest, highest: self.highest + other.highest + 1 + bits_of(count) }
    }
}

/// An e with count ≤ 2^e.
fn bits_of(count: usize) -> i64 {
    i64::from(usize::BITS - count.leading_zeros())
}

/// A number as a two's complement: its words, the least significant first, in units of 2^unit.
#[derive(Debug, Clone)]
pub(crate) struct FixedPoint {
    unit: i64,
    words: Vec<u64>,
}

impl FixedPoint {
    /// Zero, with the words for any number of a range.
    pub(crate) fn zero(range: BitRange) -> Self {
        let bits = (range.highest - range.lowest + 1) as usize;
        Self { unit: range.lowest, words: vec![0; bits.div_ceil(u64::BITS as usize)] }
    }

    /// Makes the number zero again.
    pub(crate) fn clear(&mut self) {
        self.words.fill(0);
    }

    /// Adds a double, whose bits are in the range.
    pub(crate) fn add(&mut self, term: f64) {
        let (mantissa, exponent) = decompose(term);
        self.add_words(&[mantissa.unsigned_abs()], 1, mantissa < 0, i64::from(exponent));
    }

    /// Adds a number times a double: `factor` · `other`. The product is in the range.
    pub(crate) fn add_multiple(&mut self, factor: f64, other: &Self) {
        let (mantissa, exponent) = decompose(factor);
        self.add_words(&other.words, mantissa.unsigned_abs(), mantissa < 0, i64::from(exponent) + other.unit);
    }

    /// Adds ± `words` · `factor` · 2^`exponent`, the words as a two's complement. All is taken modulo a power of two
    /// above twice the range, so that words beyond the last one, which repeat its sign, are cut off.
    fn add_words(&mut self, words: &[u64], factor: u64, is_negative: bool, exponent: i64) {
        if factor == 0 {
            return;
        }
        let shift = (exponent - self.unit) as usize;
        let (first, places) = (shift / u64::BITS as usize, shift as u32 % u64::BITS);
        let beyond = if words.last().is_some_and(|top| top >> 63 == 1) { u64::MAX } else { 0 };
        let flipped = if is_negative { u64::MAX } else { 0 };
        // −x is !x + 1
        let (mut carried_product, mut carried_sum, mut before) = (0, u128::from(is_negative), 0);
        let source = words.iter().copied().chain(std::iter::repeat(beyond));
        for (word, own) in source.zip(self.words.iter_mut().skip(first)) {
            let product = u128::from(word) * u128::from(factor) + carried_product;
            carried_product = product >> 64;
            let low = product as u64;
            let shifted = ((u128::from(low) << 64 | u128::from(before)) << places >> 64) as u64;
            before = low;
            let sum = u128::from(*own) + u128::from(shifted ^ flipped) + carried_sum;
            *own = sum as u64;
            carried_sum = sum >> 64;
        }
    }

    /// The number.
    pub(crate) fn to_dyadic(&self) -> Dyadic {
        let is_negative = self.words.last().is_some_and(|top| top >> 63 == 1);
        let mut negated = Self { unit: 0, words: vec![0; self.words.len()] };
        negated.add_words(&self.words, 1, true, 0);
        let magnitude = if is_negative { &negated.words } else { &self.words };
        let bytes: Vec<u8> = magnitude.iter().flat_map(|word| word.to_le_bytes()).collect();
        let magnitude = IBig::from(UBig::from_le_bytes(&bytes));
        Dyadic::new(if is_negative { -magnitude } else { magnitude }, self.unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn zero_and_the_ends_of_the_range_of_doubles() {
        assert!(FixedPoint::zero(BitRange::of_sums([], 0)).to_dyadic().is_zero());
        let terms = [f64::MAX, -f64::from_bits(1), 0.0, -f64::MAX, -f64::MAX];
        let mut sum = FixedPoint::zero(BitRange::of_sums(terms, terms.len()));
        let mut exact = Dyadic::zero();
        for term in terms {
            sum.add(term);
            exact = exact + Dyadic::from_f64(term);
            assert_eq!(sum.to_dyadic(), exact);
        }
        sum.clear();
        assert!(sum.to_dyadic().is_zero());
    }

    properties! {
        #[test]
        fn sums_and_products_are_those_of_dyadic_numbers(
            terms in proptest::collection::vec(any::<u64>().prop_map(f64::from_bits), 1..9), scale in 0i64..1_000
        ) {
            let terms: Vec<f64> = terms.into_iter().filter(|term| term.is_finite()).collect();
            // of one size nearly, so that carries go through many words, or of any size
            let near = |term: f64| if scale < 500 { term } else { term % 1e10 + 1e-10 };
            let terms: Vec<f64> = terms.into_iter().map(near).collect();
            let range = BitRange::of_sums(terms.iter().copied(), terms.len());
            let mut sum = FixedPoint::zero(range);
            let mut products = FixedPoint::zero(range.of_products(range, terms.len()));
            let (mut exact_sum, mut exact_products) = (Dyadic::zero(), Dyadic::zero());
            for &term in &terms {
                products.add_multiple(term, &sum);
                sum.add(term);
                exact_products = exact_products + &exact_sum * &Dyadic::from_f64(term);
                exact_sum = exact_sum + Dyadic::from_f64(term);
                prop_assert_eq!(sum.to_dyadic(), exact_sum.clone());
                prop_assert_eq!(products.to_dyadic(), exact_products.clone());
            }
        }
    }

    #[test]
    fn the_least_double_alone_is_kept() {
        let least = f64::from_bits(1);
        let mut sum = FixedPoint::zero(BitRange::of_sums([least], 1));
        sum.add(least);
        assert_eq!(sum.to_dyadic(), Dyadic::from_f64(least));
    }

    #[test]
    fn a_range_has_its_sign_at_its_highest_bit() {
        let bound = 2f64.powi(63);
        let mut number = FixedPoint::zero(BitRange { lowest: 0, highest: 64 });
        number.add(bound);
        assert_eq!(number.to_dyadic(), Dyadic::from_f64(bound));
    }

    /// The sign takes the bit above the largest one of a number.
    #[test]
    fn ranges_have_room_for_the_sign_and_one_or_two_bits_beyond() {
        for count in 1..70 {
            let largest = |number: &Dyadic| {
                let sum = number * &Dyadic::from_f64(count as f64);
                sum.binary_exponent().expect("the number is not zero")
            };
            for number in [1.0, 2.0f64.next_down()] {
                let range = BitRange::of_sums([number], count);
                assert!((2..=3).contains(&(range.highest - largest(&Dyadic::from_f64(number)))), "{count} of {number}");
            }
            let [a, b] = [(-7, 5), (-20, 31)].map(|(lowest, highest)| BitRange { lowest, highest });
            let products = a.of_products(b, count);
            let end = |range: BitRange| Dyadic::one().scaled(range.highest) - Dyadic::one().scaled(range.lowest);
            let product = end(a) * end(b);
            assert_eq!((products.lowest, product.exponent()), (-27, -27));
            assert!((2..=3).contains(&(products.highest - largest(&product))), "{count} products");
        }
    }
}
