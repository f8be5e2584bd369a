//! Quotients of big integers: exact comparisons with doubles, and doubles near them.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};

use crate::exact::grid::Grid;

/// The number numerator / denominator · 2^exponent, with a positive denominator.
#[derive(Debug, Clone)]
pub(crate) struct Proportion {
    numerator: IBig,
    denominator: IBig,
    exponent: i32,
}

impl Proportion {
    /// The number numerator / denominator · 2^exponent; the denominator may have either sign but is not zero.
    pub(crate) fn new(numerator: IBig, denominator: IBig, exponent: i32) -> Self {
        assert!(denominator != IBig::ZERO, "a proportion needs a denominator");
        let negative = denominator < IBig::ZERO;
        Self { numerator: if negative { -numerator } else { numerator }, denominator: denominator.abs(), exponent }
    }

    /// The whole number of units 2^exponent.
    pub(crate) fn whole(units: IBig, exponent: i32) -> Self {
        Self::new(units, IBig::ONE, exponent)
    }

    /// The finite double, exactly.
    pub(crate) fn of_double(number: f64) -> Self {
        let grid = Grid::of([number]);
        Self::whole(grid.units(number), grid.exponent())
    }

    /// The sum.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let exponent = self.exponent.min(other.exponent);
        let left = shifted(&self.numerator, self.exponent - exponent) * &other.denominator;
        let right = shifted(&other.numerator, other.exponent - exponent) * &self.denominator;
        Self::new(left + right, &self.denominator * &other.denominator, exponent)
    }

    /// The difference.
    pub(crate) fn minus(&self, other: &Self) -> Self {
        let negated = Self { numerator: -&other.numerator, ..other.clone() };
        self.plus(&negated)
    }

    /// The product.
    pub(crate) fn times(&self, other: &Self) -> Self {
        Self::new(
            &self.numerator * &other.numerator,
            &self.denominator * &other.denominator,
            self.exponent + other.exponent,
        )
    }

    /// The quotient, unless the divisor is zero.
    pub(crate) fn over(&self, divisor: &Self) -> Option<Self> {
        (divisor.numerator != IBig::ZERO).then(|| {
            Self::new(
                &self.numerator * &divisor.denominator,
                &self.denominator * &divisor.numerator,
                self.exponent - divisor.exponent,
            )
        })
    }

    /// The distance from zero.
    pub(crate) fn magnitude(&self) -> Self {
        Self { numerator: self.numerator.clone().abs(), ..self.clone() }
    }

    /// Exact comparison.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        self.minus(other).numerator.cmp(&IBig::ZERO)
    }

    /// A double within a few units in the last place: 0 and infinities beyond its range.
    pub(crate) fn near(&self) -> f64 {
        let bits = |number: &IBig| number.clone().abs().bit_len() as i64;
        let wanted = 64 + bits(&self.denominator) - bits(&self.numerator);
        let shift = i32::try_from(wanted).expect("numbers of a check have fewer than 2^31 bits");
        let numerator =
            if shift < 0 { &self.numerator >> shift.unsigned_abs() as usize } else { shifted(&self.numerator, shift) };
        scaled((numerator / &self.denominator).to_f64().value(), self.exponent - shift)
    }
}

/// Accepts a finite double that is within `allowed` (or the smallest double) of the exact value, and an infinity where the
/// exact value is beyond the range of doubles.
pub(crate) fn check_figure(name: &str, claimed: f64, exact: &Proportion, allowed: &Proportion) -> Result<(), String> {
    let near = exact.near();
    let accepted = if claimed.is_nan() {
        false
    } else if claimed.is_finite() {
        let error = Proportion::of_double(claimed).minus(exact).magnitude();
        let allowed = allowed.plus(&Proportion::of_double(f64::from_bits(1)));
        error.compare(&allowed) != Ordering::Greater
    } else {
        let largest = Proportion::of_double(f64::MAX.copysign(claimed));
        let beyond = if claimed > 0.0 { Ordering::Greater } else { Ordering::Less };
        claimed == near || exact.compare(&largest) == beyond
    };
    if accepted { Ok(()) } else { Err(format!("{name} is {claimed:?}, exactly it is {near:?}")) }
}

fn shifted(number: &IBig, shift: i32) -> IBig {
    number << usize::try_from(shift).expect("shifts go up only")
}

/// number · 2^exponent in steps that neither overflow nor underflow early.
fn scaled(mut number: f64, mut exponent: i32) -> f64 {
    let step = |exponent: i32| f64::from_bits(((exponent + 1023) as u64) << 52);
    while exponent > 1000 && number.is_finite() && number != 0.0 {
        number *= step(1000);
        exponent -= 1000;
    }
    while exponent < -1000 && number != 0.0 {
        number *= step(-1000);
        exponent += 1000;
    }
    number * step(exponent.clamp(-1000, 1000))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(numerator: i64, denominator: i64, exponent: i32) -> Proportion {
        Proportion::new(numerator.into(), denominator.into(), exponent)
    }

    #[test]
    fn arithmetic_by_hand() {
        let sum = of(1, 3, 0).plus(&of(1, -6, 1));
        assert_eq!(sum.compare(&of(0, 1, 0)), Ordering::Equal);
        assert_eq!(of(1, 3, 0).times(&of(3, 2, 2)).compare(&of(2, 1, 0)), Ordering::Equal);
        assert_eq!(of(1, 3, 0).compare(&Proportion::of_double(1.0 / 3.0)), Ordering::Greater);
        assert_eq!(of(-7, 2, 0).magnitude().over(&of(7, 4, 0)).map(|q| q.near()), Some(2.0));
        assert!(of(1, 1, 0).over(&of(0, 5, 0)).is_none());
    }

    #[test]
    fn figures() {
        let allowed = of(1, 8, 0);
        let accepts = |claimed: f64, exact: &Proportion| check_figure("it", claimed, exact, &allowed).is_ok();
        assert!(accepts(2.125, &of(2, 1, 0)) && !accepts(2.25, &of(2, 1, 0)));
        assert!(accepts(f64::INFINITY, &of(1, 1, 1024)) && !accepts(f64::NEG_INFINITY, &of(1, 1, 1024)));
        assert!(!accepts(f64::INFINITY, &of(2, 1, 0)));
        for exact in [of(2, 1, 0), of(0, 1, 0), of(-1, 1, 1024)] {
            assert!(!accepts(f64::NAN, &exact), "{exact:?}");
        }
    }

    #[test]
    fn doubles_near_a_proportion() {
        assert_eq!(of(1, 3, 0).near(), 1.0 / 3.0);
        assert_eq!(of(-3, 4, 0).near(), -0.75);
        assert_eq!(of(0, 4, 9).near(), 0.0);
        let long = Proportion::new(IBig::from(-3) << 5000, IBig::from(4), -4990);
        assert_eq!(long.near(), -768.0);
        assert_eq!(of(1, 1, 4000).near(), f64::INFINITY);
        assert_eq!(of(1, 1, -4000).near(), 0.0);
        assert_eq!(Proportion::of_double(f64::MAX).near(), f64::MAX);
        assert_eq!(Proportion::of_double(1e-300).near(), 1e-300);
        let wide = Proportion::of_double(f64::MAX).over(&Proportion::of_double(f64::MAX));
        assert_eq!(wide.map(|one| one.near()), Some(1.0));
    }
}
