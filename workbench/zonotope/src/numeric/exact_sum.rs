//! The exact sum of doubles: a fixed-point accumulator as wide as the whole range of doubles.
//!
//! The accumulator holds the sum as Σ digit_i · 2^(32 i − 1074) with signed 64-bit digits. A double touches three
//! neighbouring digits and adds less than 2^32 to each, so carries are settled only once in 2^30 additions.

use dashu_int::{IBig, UBig};

use super::dyadic::Dyadic;
use super::scaling::decompose;

/// a + b as an unevaluated sum of two doubles, the rounded sum and its error; exact unless the sum overflows (Knuth).
#[inline]
pub fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_in_sum = sum - a;
    (sum, (a - (sum - b_in_sum)) + (b - b_in_sum))
}

const DIGITS: usize = 68;
const LOWEST_EXPONENT: i32 = -1074;
const ADDITIONS_BETWEEN_CARRIES: u32 = 1 << 30;

/// An exact accumulator of doubles; O(1) an addition, 550 bytes.
#[derive(Debug, Clone)]
pub struct ExactSum {
    digits: [i64; DIGITS],
    additions: u32,
}

impl Default for ExactSum {
    fn default() -> Self {
        Self { digits: [0; DIGITS], additions: 0 }
    }
}

impl ExactSum {
    /// Adds a finite double, exactly.
    pub fn add(&mut self, value: f64) {
        assert!(value.is_finite(), "only finite doubles are numbers");
        let (mantissa, exponent) = decompose(value);
        let position = (exponent - LOWEST_EXPONENT) as usize;
        let first = position / 32;
        let shifted = u128::from(mantissa.unsigned_abs()) << (position % 32);
        let sign = mantissa.signum();
        for (digit, place) in self.digits[first..first + 3].iter_mut().zip([0, 32, 64]) {
            *digit += sign * i64::from((shifted >> place) as u32);
        }
        self.additions += 1;
        if self.additions == ADDITIONS_BETWEEN_CARRIES {
            self.carry();
        }
    }

    /// Brings every digit but the last one between 0 and 2^32, so that the last one has the sign of the sum.
    fn carry(&mut self) {
        for i in 0..DIGITS - 1 {
            let carry = self.digits[i] >> 32;
            self.digits[i] -= carry << 32;
            self.digits[i + 1] += carry;
        }
        self.additions = 1;
    }

    /// The sum, exactly, with no more digits than it needs: what is computed from it depends on how long it is.
    pub fn value(&self) -> Dyadic {
        let Some(first) = self.digits.iter().position(|digit| *digit != 0) else {
            return Dyadic::zero();
        };
        let mut magnitude = self.clone();
        magnitude.carry();
        let is_negative = magnitude.digits[DIGITS - 1] < 0;
        if is_negative {
            magnitude.digits = self.digits.map(|digit| -digit);
            magnitude.carry();
        }
        let last = magnitude.digits.iter().rposition(|digit| *digit != 0).unwrap_or(first);
        let mut bytes = [0; 4 * DIGITS];
        for (place, digit) in bytes.chunks_exact_mut(4).zip(&magnitude.digits[first..=last]) {
            place.copy_from_slice(&(*digit as u32).to_le_bytes());
        }
        let mantissa = IBig::from(UBig::from_le_bytes(&bytes[..4 * (last - first + 1)]));
        let exponent = i64::from(LOWEST_EXPONENT) + 32 * first as i64;
        Dyadic::new(if is_negative { -mantissa } else { mantissa }, exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn cancellation_leaves_the_smallest_denormal() {
        let mut sum = ExactSum::default();
        for value in [f64::MAX, f64::from_bits(1), f64::MAX, -f64::MAX, -f64::MAX] {
            sum.add(value);
        }
        assert_eq!(sum.value().to_f64(), f64::from_bits(1));
    }

    #[test]
    fn a_carry_keeps_the_sum() {
        let mut sum = ExactSum::default();
        for value in [-1.0, f64::MAX, 3e-310] {
            sum.add(value);
        }
        let before = sum.value();
        sum.carry();
        assert_eq!(sum.value(), before);
    }

    properties! {
        #[test]
        fn agrees_with_dyadic_sums(bits in proptest::collection::vec(any::<u64>(), 0..40)) {
            let values: Vec<f64> = bits.into_iter().map(f64::from_bits).filter(|v| v.is_finite()).collect();
            let mut sum = ExactSum::default();
            let mut truth = Dyadic::zero();
            for &v in &values {
                sum.add(v);
                truth = &truth + &Dyadic::from_f64(v);
            }
            prop_assert_eq!(sum.value(), truth);
        }
    }
}
