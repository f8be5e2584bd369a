//! Rational numbers as a question or an answer writes them.

use dashu_int::IBig;
use dashu_int::ops::{Abs, Gcd};

use super::grid::Grid;

/// An exact number: a numerator over a positive denominator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fraction {
    numerator: IBig,
    denominator: IBig,
}

impl Fraction {
    /// The quotient of two integers; `None` if the denominator is zero.
    pub fn new(numerator: impl Into<IBig>, denominator: impl Into<IBig>) -> Option<Self> {
        let (numerator, denominator) = (numerator.into(), denominator.into());
        let is_negative = denominator < IBig::ZERO;
        (denominator != IBig::ZERO).then(|| Self {
            numerator: if is_negative { -numerator } else { numerator },
            denominator: denominator.abs(),
        })
    }

    /// The exact value of a double; `None` if it is not finite.
    pub fn of_double(number: f64) -> Option<Self> {
        if !number.is_finite() {
            return None;
        }
        let grid = Grid::of([number]);
        let (units, shift) = (grid.units(number), grid.exponent().unsigned_abs() as usize);
        if grid.exponent() < 0 { Self::new(units, IBig::ONE << shift) } else { Self::new(units << shift, IBig::ONE) }
    }

    /// Reads `num` or `num/den` in decimal digits, the denominator positive.
    pub fn parse(text: &str) -> Option<Self> {
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let number = |digits: &str| IBig::from_str_radix(digits, 10).ok();
        let denominator = number(denominator)?;
        (denominator > IBig::ZERO).then_some(Self { numerator: number(numerator)?, denominator })
    }

    /// The numerator.
    pub fn numerator(&self) -> &IBig {
        &self.numerator
    }

    /// The positive denominator.
    pub fn denominator(&self) -> &IBig {
        &self.denominator
    }
}

/// A common multiple of all denominators.
pub(crate) fn common_denominator<'a>(fractions: impl IntoIterator<Item = &'a Fraction>) -> IBig {
    fractions.into_iter().fold(IBig::ONE, |common, fraction| {
        let shared = IBig::from((&common).gcd(&fraction.denominator));
        common / shared * &fraction.denominator
    })
}

/// The fractions in units of 1 / `common`, a common multiple of their denominators.
pub(crate) fn whole_numbers(fractions: &[Fraction], common: &IBig) -> Vec<IBig> {
    fractions.iter().map(|fraction| &fraction.numerator * (common / &fraction.denominator)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_read_and_normalised() {
        let half = Fraction::new(-3, -6).expect("the denominator is not zero");
        assert_eq!((half.numerator(), half.denominator()), (&IBig::from(3), &IBig::from(6)));
        assert_eq!(Fraction::parse("-7/2"), Fraction::new(7, -2));
        assert_eq!(Fraction::parse("12"), Fraction::new(12, 1));
        assert_eq!(Fraction::of_double(-0.375), Fraction::new(-3, 8));
        assert_eq!(Fraction::of_double(6.0), Fraction::new(6, 1));
        for text in ["", "1/0", "1/-2", "one", "1/2/3"] {
            assert_eq!(Fraction::parse(text), None, "{text}");
        }
        assert_eq!((Fraction::new(1, 0), Fraction::of_double(f64::NAN)), (None, None));
    }

    #[test]
    fn the_common_denominator_is_the_least_one() {
        let fractions = [(1, 6), (-3, 4), (5, 12), (7, 1)].map(|(numerator, denominator)| {
            Fraction::new(numerator, denominator).expect("the denominator is not zero")
        });
        let common = common_denominator(&fractions);
        assert_eq!(common, IBig::from(12));
        assert_eq!(whole_numbers(&fractions, &common), [2, -9, 5, 84].map(IBig::from));
        assert_eq!(common_denominator([]), IBig::ONE);
    }
}
