//! Floating point whose exponents have no bounds that matter: numbers that differ by any power of two keep their
//! places, so that bounds of them tell which are certainly larger.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::proportion::Proportion;

/// A number mantissa · 2^exponent with a mantissa of a magnitude from 1/2 to 1, or zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Wide {
    mantissa: f64,
    exponent: i64,
}

/// The exponent of zero, below all others, far enough from the end of the range for sums.
const OF_ZERO: i64 = i64::MIN / 4;

impl Wide {
    pub(crate) const ZERO: Self = Self { mantissa: 0.0, exponent: OF_ZERO };

    /// The number value · 2^exponent of a finite normal value, or of zero.
    pub(crate) fn new(value: f64, exponent: i64) -> Self {
        if value == 0.0 {
            return Self::ZERO;
        }
        let own = i64::from((value.to_bits() >> 52) as u16 & 0x7ff) - 1022;
        Self { mantissa: value * power_of_two(-(own / 2)) * power_of_two(-(own - own / 2)), exponent: exponent + own }
    }

    /// A whole number within a relative 2^-52.
    pub(crate) fn of_whole(number: &IBig) -> Self {
        let dropped = number.bit_len().saturating_sub(64);
        let leading = if dropped == 0 { number.to_f64().value() } else { (number >> dropped).to_f64().value() };
        Self::new(leading, dropped as i64)
    }

    pub(crate) fn mantissa(self) -> f64 {
        self.mantissa
    }

    pub(crate) fn exponent(self) -> i64 {
        self.exponent
    }

    /// The number as a proportion.
    pub(crate) fn exactly(self) -> Proportion {
        let exponent = i32::try_from(self.exponent).unwrap_or(0);
        Proportion::of_double(self.mantissa).times(&Proportion::whole(IBig::ONE, exponent))
    }

    /// The quotient, rounded once; `None` if the divisor is zero.
    pub(crate) fn over(self, divisor: Self) -> Option<Self> {
        let quotient = || Self::new(self.mantissa / divisor.mantissa, self.exponent - divisor.exponent);
        (divisor.mantissa != 0.0).then(quotient)
    }

    /// The difference, within a relative 2^-52 of the larger magnitude of the two.
    pub(crate) fn minus(self, other: Self) -> Self {
        let unit = self.exponent.max(other.exponent);
        let aligned = |number: Self| number.mantissa * power_of_two(number.exponent - unit);
        Self::new(aligned(self) - aligned(other), unit)
    }

    /// The root of a number that is not negative, rounded once.
    pub(crate) fn root(self) -> Self {
        let odd = self.exponent.rem_euclid(2);
        Self::new((self.mantissa * power_of_two(odd - 2)).sqrt(), (self.exponent - odd + 2) / 2)
    }

    pub(crate) fn negated(self) -> Self {
        Self { mantissa: -self.mantissa, ..self }
    }

    /// The number moved by a part of itself, up where the part is positive, down where it is negative.
    pub(crate) fn moved(self, part: f64) -> Self {
        Self::new(self.mantissa + self.mantissa.abs() * part, self.exponent)
    }

    pub(crate) fn compare(self, other: Self) -> Ordering {
        let sign = |number: Self| number.mantissa.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
        let by_size = || self.exponent.cmp(&other.exponent).then(self.mantissa.abs().total_cmp(&other.mantissa.abs()));
        sign(self).cmp(&sign(other)).then_with(|| match sign(self) {
            Ordering::Less => by_size().reverse(),
            _ => by_size(),
        })
    }
}

/// 2^exponent for exponents up to 1023; zero below the normal doubles.
pub(crate) fn power_of_two(exponent: i64) -> f64 {
    if exponent < -1022 { 0.0 } else { f64::from_bits(((exponent + 1023) as u64) << 52) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_by_hand() {
        let of = |number: i64, shift: usize| Wide::of_whole(&(IBig::from(number) << shift));
        let (twelve, huge) = (of(12, 0), of(3, 9_002));
        assert_eq!((twelve.mantissa(), twelve.exponent()), (0.75, 4));
        assert_eq!(huge.over(twelve), Some(of(1, 9_000)));
        assert_eq!((of(9, 9_004).root(), of(2, 1).root()), (of(3, 4_502), of(2, 0)));
        assert_eq!((huge.minus(twelve), twelve.minus(of(5, 1)), twelve.minus(twelve)), (huge, of(1, 1), Wide::ZERO));
        assert_eq!((twelve.over(Wide::ZERO), Wide::ZERO.over(twelve)), (None, Some(Wide::ZERO)));
        assert_eq!((of(-4, 0).moved(0.25), of(4, 0).moved(-0.25)), (of(-3, 0), of(3, 0)));
        assert_eq!(Wide::new(f64::MIN_POSITIVE, 1_022), of(1, 0));
        assert_eq!(Wide::new(f64::MAX, 0).exponent(), 1_024);
        assert_eq!((twelve.negated().exactly().nearest(), Wide::ZERO.exactly().nearest()), (-12.0, 0.0));
    }

    #[test]
    fn numbers_are_in_order() {
        let of = |number: i64, shift: usize| Wide::of_whole(&(IBig::from(number) << shift));
        let ascending = [of(-1, 9_000), of(-3, 0), of(-2, 0), Wide::ZERO, of(1, 0), of(5, 0), of(6, 0), of(1, 4_000)];
        for (i, a) in ascending.iter().enumerate() {
            for (j, b) in ascending.iter().enumerate() {
                assert_eq!(a.compare(*b), i.cmp(&j), "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn powers_of_two_are_normal_doubles_or_zero() {
        assert_eq!([0, 1, -1, 1_023].map(power_of_two), [1.0, 2.0, 0.5, 2.0_f64.powi(1_023)]);
        assert_eq!((power_of_two(-1_022), power_of_two(-1_023)), (f64::MIN_POSITIVE, 0.0));
    }
}
