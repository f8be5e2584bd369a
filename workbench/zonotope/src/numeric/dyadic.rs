//! Exact dyadic numbers: mantissa · 2^exponent over arbitrarily long integers.
//!
//! Every finite double is a dyadic number, and sums and products of dyadic numbers are dyadic, so a polynomial in the
//! coordinates of the input is evaluated without any rounding, over the whole range of doubles. Unlike a rational, a
//! dyadic number needs no greatest common divisor.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::ops::{Gcd, SquareRoot, UnsignedAbs};
use dashu_int::{IBig, Sign, Word};
use dashu_ratio::RBig;

use super::scaling::{decompose, scale_by_power_of_two};

/// An exact number mantissa · 2^exponent.
#[derive(Debug, Clone)]
pub struct Dyadic {
    mantissa: IBig,
    exponent: i64,
}

impl Dyadic {
    /// Zero.
    pub const fn zero() -> Self {
        Self { mantissa: IBig::ZERO, exponent: 0 }
    }

    /// One.
    pub const fn one() -> Self {
        Self { mantissa: IBig::ONE, exponent: 0 }
    }

    /// The number mantissa · 2^exponent.
    pub fn new(mantissa: IBig, exponent: i64) -> Self {
        Self { mantissa, exponent }
    }

    /// The exact value of a double.
    ///
    /// # Panics
    /// On NaN and infinities: the types that hold input refuse them when they are made.
    pub fn from_f64(value: f64) -> Self {
        assert!(value.is_finite(), "only finite doubles are numbers");
        let (mantissa, exponent) = decompose(value);
        Self { mantissa: IBig::from(mantissa), exponent: i64::from(exponent) }
    }

    /// The number times 2^shift.
    pub fn scaled(mut self, shift: i64) -> Self {
        self.exponent += shift;
        self
    }

    /// The exponent of a power of two of which the number is a whole multiple.
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// The number in units of 2^`exponent`, rounded down if it is not a whole number of them.
    pub fn units(&self, exponent: i64) -> IBig {
        let places = (self.exponent - exponent).unsigned_abs() as usize;
        if self.is_zero() {
            IBig::ZERO
        } else if self.exponent < exponent {
            &self.mantissa >> places
        } else {
            &self.mantissa << places
        }
    }

    /// The sign, as the order of the number against zero.
    pub fn sign(&self) -> Ordering {
        if self.is_zero() {
            Ordering::Equal
        } else if self.mantissa.sign() == Sign::Negative {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    }

    /// Whether the number is zero.
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// The square root of a number that is not negative, rounded up to 64 bits or more; exact where it has so few.
    pub(crate) fn root_above(&self) -> Self {
        // an even exponent, and a mantissa of which the root has 64 bits
        let room = (128 - self.bits()).max(0);
        let shift = room + (self.exponent - room).rem_euclid(2);
        let places = usize::try_from(shift).expect("at most 129 places are made");
        let square = &self.mantissa << places;
        let root = IBig::from((&square).unsigned_abs().sqrt());
        let root = if &root * &root == square { root } else { root + IBig::ONE };
        Self::new(root, (self.exponent - shift) / 2)
    }

    /// How many bits the mantissa's magnitude has.
    fn bits(&self) -> i64 {
        let (_, words) = self.mantissa.as_sign_words();
        words.last().map_or(0, |top| i64::from(Word::BITS) * words.len() as i64 - i64::from(top.leading_zeros()))
    }

    /// The absolute value.
    pub fn abs(self) -> Self {
        if self.sign() == Ordering::Less { -self } else { self }
    }

    /// The number as a reduced fraction.
    pub fn to_rational(&self) -> RBig {
        let shift = usize::try_from(self.exponent.unsigned_abs()).expect("exponents stay far below the address space");
        if self.exponent >= 0 {
            RBig::from(self.mantissa.clone() << shift)
        } else {
            RBig::from_parts(self.mantissa.clone(), dashu_int::UBig::ONE << shift)
        }
    }

    /// A double head and an exponent with number ≈ head · 2^exponent; relative error at most 2^-52.
    pub(crate) fn leading(&self) -> (f64, i64) {
        const WORDS: usize = (u128::BITS / Word::BITS) as usize;
        let (sign, words) = self.mantissa.as_sign_words();
        let (rest, leading) = words.split_at(words.len().saturating_sub(WORDS));
        let top = leading.iter().rev().fold(0, |top: u128, &word| top << Word::BITS | u128::from(word));
        let drop = (u128::BITS - top.leading_zeros()).saturating_sub(63);
        let head = (top >> drop) as u64;
        let exponent = self.exponent + rest.len() as i64 * i64::from(Word::BITS) + i64::from(drop);
        if sign == Sign::Positive {
            return (head as f64, exponent);
        }
        // downwards, as a shift rounds
        let is_cut = u128::from(head) << drop != top || rest.iter().any(|word| *word != 0);
        (-((head + u64::from(is_cut)) as f64), exponent)
    }

    /// The exponent e with 2^e ≤ |number| < 2^(e+1); `None` for zero.
    pub fn binary_exponent(&self) -> Option<i64> {
        let bits = self.bits();
        (bits > 0).then(|| self.exponent + bits - 1)
    }

    /// The quotient of two numbers as a double, with relative error at most 2^-50 plus one denormal step; ±∞ on
    /// overflow, NaN when the divisor is zero.
    pub fn ratio(&self, divisor: &Self) -> f64 {
        let (numerator, e) = self.leading();
        let (denominator, f) = divisor.leading();
        if denominator == 0.0 {
            return f64::NAN;
        }
        scale_by_power_of_two(numerator / denominator, e - f)
    }

    /// The quotient of two numbers as a double, off by at most slightly more than half a unit in the last place; as
    /// [`ratio`](Self::ratio) where that is not finite.
    pub fn rounded_ratio(&self, divisor: &Self) -> f64 {
        let first = self.ratio(divisor);
        if first.is_infinite() {
            // Near the largest double the first quotient may overflow though the exact one does not.
            let half = self.clone().scaled(-1);
            let first_half = half.ratio(divisor);
            return if first_half.is_finite() { 2.0 * half.corrected(first_half, divisor) } else { first };
        }
        if first.is_nan() { first } else { self.corrected(first, divisor) }
    }

    /// The quotient from a first one that is finite, by what that leaves of the number.
    fn corrected(&self, first: f64, divisor: &Self) -> f64 {
        first + (self - &(divisor * &Self::from_f64(first))).ratio(divisor)
    }

    /// The number as a double, with relative error at most 2^-50 plus one denormal step; ±∞ on overflow.
    pub fn to_f64(&self) -> f64 {
        let (head, exponent) = self.leading();
        scale_by_power_of_two(head, exponent)
    }
}

/// Divides numbers by what they have in common, a positive number: their ratios and signs stay, their digits become
/// few.
pub fn remove_common_factor(numbers: &mut [Dyadic]) {
    let lowest = numbers.iter().filter(|v| !v.is_zero()).map(|v| v.exponent).min();
    let Some(lowest) = lowest else { return };
    for v in numbers.iter_mut() {
        let lift = if v.is_zero() { 0 } else { (v.exponent - lowest) as usize };
        *v = Dyadic::new(v.mantissa.clone() << lift, 0);
    }
    let common = numbers.iter().filter(|v| !v.is_zero()).fold(IBig::ZERO, |gcd, v| match gcd == IBig::ZERO {
        true => v.mantissa.clone(),
        false => IBig::from((&gcd).gcd(&v.mantissa)),
    });
    let common = IBig::from(common.unsigned_abs());
    if common != IBig::ONE {
        numbers.iter_mut().for_each(|v| v.mantissa = &v.mantissa / &common);
    }
}

/// By how many places the mantissa of the first of two numbers is shifted up to have the unit of the second, and the
/// other way round: one of both stays as it is. Zero takes any unit.
fn shifts(a: &Dyadic, b: &Dyadic) -> [usize; 2] {
    if a.is_zero() || b.is_zero() {
        return [0; 2];
    }
    [(a.exponent - b.exponent).max(0) as usize, (b.exponent - a.exponent).max(0) as usize]
}

/// The exponent of the unit in which both are whole numbers.
fn common_exponent(a: &Dyadic, b: &Dyadic) -> i64 {
    match (a.is_zero(), b.is_zero()) {
        (true, _) => b.exponent,
        (_, true) => a.exponent,
        _ => a.exponent.min(b.exponent),
    }
}

/// Sums and differences of numbers that are owned or not: a mantissa that need not be shifted is not copied.
macro_rules! combine_aligned {
    ($operation:ident, $function:ident, $operator:tt) => {
        impl $operation for &Dyadic {
            type Output = Dyadic;
            fn $function(self, other: &Dyadic) -> Dyadic {
                let mantissa = match shifts(self, other) {
                    [0, 0] => &self.mantissa $operator &other.mantissa,
                    [0, up] => &self.mantissa $operator (&other.mantissa << up),
                    [up, _] => (&self.mantissa << up) $operator &other.mantissa,
                };
                Dyadic::new(mantissa, common_exponent(self, other))
            }
        }

        impl $operation for Dyadic {
            type Output = Dyadic;
            fn $function(self, other: Dyadic) -> Dyadic {
                let exponent = common_exponent(&self, &other);
                let mantissa = match shifts(&self, &other) {
                    [0, 0] => self.mantissa $operator other.mantissa,
                    [0, up] => self.mantissa $operator (other.mantissa << up),
                    [up, _] => (self.mantissa << up) $operator other.mantissa,
                };
                Dyadic::new(mantissa, exponent)
            }
        }
    };
}

combine_aligned!(Add, add, +);
combine_aligned!(Sub, sub, -);

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        Dyadic::new(&self.mantissa * &other.mantissa, self.exponent + other.exponent)
    }
}

impl Neg for Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic::new(-self.mantissa, self.exponent)
    }
}

impl Mul for Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Dyadic) -> Dyadic {
        &self * &other
    }
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Dyadic {}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let sign = self.sign();
        let by_sign = sign.cmp(&other.sign());
        let by_size = || self.binary_exponent().cmp(&other.binary_exponent());
        match by_sign {
            Ordering::Equal if sign.is_eq() => Ordering::Equal,
            Ordering::Equal => match by_size() {
                Ordering::Equal => (self - other).sign(),
                order if sign.is_gt() => order,
                order => order.reverse(),
            },
            order => order,
        }
    }
}

#[cfg(test)]
mod tests;
