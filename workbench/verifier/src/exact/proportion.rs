//! Quotients of big integers: exact comparisons with doubles, and the doubles nearest to them.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest, DivEuclid, DivRem, SquareRoot};

use super::fraction::Fraction;
use super::grid::Grid;

/// The exponent of the smallest positive double.
const SMALLEST_EXPONENT: i64 = -1074;

/// The smallest positive double.
const SMALLEST: f64 = f64::from_bits(1);

/// The exponent of the last place of the largest double.
const LARGEST_EXPONENT: i64 = 971;

/// The bits of the quotient of which a root is taken.
const ROOT_BITS: i64 = 240;

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

    /// The fraction, exactly.
    pub(crate) fn of_fraction(fraction: &Fraction) -> Self {
        Self::new(fraction.numerator().clone(), fraction.denominator().clone(), 0)
    }

    /// The finite double, exactly.
    pub(crate) fn of_double(number: f64) -> Self {
        let grid = Grid::of([number]);
        Self::whole(grid.units(number), grid.exponent())
    }

    /// The exponent of a unit of which the number is a whole multiple, if its denominator is 1.
    pub(crate) fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The number of whole units 2^exponent that the number holds.
    pub(crate) fn floor_at(&self, exponent: i32) -> IBig {
        if self.exponent < exponent {
            return (&self.numerator).div_euclid(&shifted(&self.denominator, exponent - self.exponent));
        }
        shifted(&self.numerator, self.exponent - exponent).div_euclid(&self.denominator)
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

    /// Whether it is zero.
    pub(crate) fn is_zero(&self) -> bool {
        self.numerator == IBig::ZERO
    }

    /// Whether it is below zero.
    pub(crate) fn is_negative(&self) -> bool {
        self.numerator < IBig::ZERO
    }

    /// The square root of a number that is not negative, rounded: its relative error is below 2^-100.
    pub(crate) fn root(&self) -> Self {
        let bits = |number: &IBig| i64::try_from(number.bit_len()).expect("numbers of a check fit into memory");
        // The quotient gets more than 240 bits, and an even exponent.
        let missing = (ROOT_BITS + bits(&self.denominator) - bits(&self.numerator)).max(0);
        let shift = missing + (missing + i64::from(self.exponent)).rem_euclid(2);
        let places = usize::try_from(shift).expect("the shift is not negative");
        let quotient = (&self.numerator << places) / &self.denominator;
        let exponent = (i64::from(self.exponent) - shift) / 2;
        let root = if quotient < IBig::ZERO { IBig::ZERO } else { IBig::from(quotient.sqrt()) };
        Self::whole(root, i32::try_from(exponent).expect("numbers of a check fit into memory"))
    }

    /// Exact comparison.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        self.minus(other).numerator.cmp(&IBig::ZERO)
    }

    /// The nearest double, of two equally near ones the even one: infinite from half a unit above the largest on.
    pub(crate) fn nearest(&self) -> f64 {
        if self.numerator == IBig::ZERO {
            return 0.0;
        }
        let bits = |number: &IBig| i64::try_from(number.bit_len()).expect("numbers of a check fit into memory");
        // The value lies in [2^leading, 2^(leading + 2)), and 55 bits of it tell the nearest double, or fewer where
        // doubles have fewer.
        let leading = bits(&self.numerator) - bits(&self.denominator) - 1 + i64::from(self.exponent);
        let unit = (leading - 54).max(SMALLEST_EXPONENT - 2);
        let shift = i64::from(self.exponent) - unit;
        let (mut above, mut below) = (self.numerator.clone().abs(), self.denominator.clone());
        let places = usize::try_from(shift.unsigned_abs()).expect("numbers of a check fit into memory");
        if shift < 0 {
            below <<= places
        } else {
            above <<= places
        };
        let (units, rest) = above.div_rem(&below);
        let units = u64::try_from(units).expect("the unit leaves at most 57 bits");
        let size = rounded(units, rest != IBig::ZERO, unit);
        if self.numerator < IBig::ZERO { -size } else { size }
    }
}

/// Accepts a finite double that is within `allowed` of the exact value or nearer to it than any two doubles are to
/// each other, and an infinity where the exact value rounds to it.
pub(crate) fn check_figure(name: &str, claimed: f64, exact: &Proportion, allowed: &Proportion) -> Result<(), String> {
    let nearest = exact.nearest();
    let accepted = if claimed.is_finite() {
        let error = Proportion::of_double(claimed).minus(exact).magnitude();
        error.compare(allowed) != Ordering::Greater || error.compare(&Proportion::of_double(SMALLEST)) == Ordering::Less
    } else {
        claimed == nearest || is_beyond(exact, claimed)
    };
    if accepted { Ok(()) } else { Err(format!("{name} is {claimed:?}, exactly it is {nearest:?}")) }
}

/// Whether the exact value exceeds the largest double on the side of an infinity; nothing is beyond NaN.
fn is_beyond(exact: &Proportion, infinity: f64) -> bool {
    let beyond = if infinity > 0.0 { Ordering::Greater } else { Ordering::Less };
    infinity.is_infinite() && exact.compare(&Proportion::of_double(f64::MAX.copysign(infinity))) == beyond
}

/// Accepts the double nearest to an exact coefficient, or one of the two beside it, if it lies in [−1, 1].
pub(crate) fn check_coefficient(name: &str, claimed: f64, exact: &Proportion) -> Result<(), String> {
    let nearest = exact.nearest();
    if !(-1.0..=1.0).contains(&claimed) {
        return Err(format!("{name} is {claimed:?}, outside [-1, 1]"));
    }
    if (nearest.next_down()..=nearest.next_up()).contains(&claimed) {
        return Ok(());
    }
    Err(format!("{name} is {claimed:?}, but the other coefficients imply {nearest:?}"))
}

fn shifted(number: &IBig, shift: i32) -> IBig {
    number << usize::try_from(shift).expect("shifts go up only")
}

/// The double nearest to (`units`, and a part of a unit if there is `more`) · 2^`exponent`: the unit is at least two
/// places finer than that of the double, so that the places that are dropped tell which way to round.
fn rounded(units: u64, more: bool, exponent: i64) -> f64 {
    let length = i64::from(u64::BITS - units.leading_zeros());
    let dropped = (length - i64::from(f64::MANTISSA_DIGITS)).max(SMALLEST_EXPONENT - exponent);
    let (kept, rest) = (units >> dropped, units & ((1 << dropped) - 1));
    let half = 1 << (dropped - 1);
    let is_up = rest > half || rest == half && (more || kept % 2 == 1);
    let (kept, exponent) = ((kept + u64::from(is_up)) as f64, exponent + dropped);
    if exponent > LARGEST_EXPONENT {
        return f64::INFINITY;
    }
    // In two steps, of which neither leaves the range of doubles unless the result does.
    let power = |exponent: i64| f64::from_bits(((exponent + 1023) as u64) << 52);
    kept * power(exponent / 2) * power(exponent - exponent / 2)
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
        assert_eq!(of(-7, 2, 0).magnitude().over(&of(7, 4, 0)).map(|q| q.nearest()), Some(2.0));
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
    fn nothing_but_zero_is_near_zero() {
        let accepts = |claimed: f64, exact: &Proportion| check_figure("it", claimed, exact, &of(0, 1, 0)).is_ok();
        assert!(accepts(0.0, &of(0, 1, 0)) && accepts(-0.0, &of(0, 1, 0)));
        assert!(!accepts(SMALLEST, &of(0, 1, 0)) && !accepts(-SMALLEST, &of(0, 1, 0)));
        // two thirds of the smallest double: that or nothing
        let between = of(2, 3, -1074);
        assert!(accepts(0.0, &between) && accepts(SMALLEST, &between) && !accepts(2.0 * SMALLEST, &between));
    }

    #[test]
    fn coefficients_lie_beside_what_is_implied() {
        let accepts = |claimed: f64, exact: &Proportion| check_coefficient("it", claimed, exact).is_ok();
        let third = 1.0 / 3.0_f64;
        assert!([third.next_down(), third, third.next_up()].into_iter().all(|claimed| accepts(claimed, &of(1, 3, 0))));
        assert!(!accepts(third.next_up().next_up(), &of(1, 3, 0)) && !accepts(-third, &of(1, 3, 0)));
        assert!(accepts(1.0, &of(1, 1, 0)) && accepts(1.0_f64.next_down(), &of(1, 1, 0)));
        assert!(!accepts(1.0_f64.next_up(), &of(1, 1, 0)) && !accepts(f64::NAN, &of(1, 1, 0)));
        assert!(accepts(0.0, &of(0, 1, 0)) && !accepts(1e-300, &of(0, 1, 0)));
    }

    #[test]
    fn rounding_is_to_nearest_even() {
        // half-way between two doubles, a little more and a little less
        let one = IBig::ONE << 53;
        let nearest = |numerator: IBig, exponent: i32| Proportion::whole(numerator, exponent).nearest();
        assert_eq!(nearest(&one + 1, -53), 1.0);
        assert_eq!(nearest(&one + 3, -53), 1.0 + 2.0 * f64::EPSILON);
        assert_eq!(nearest(((&one + 1) << 90_usize) + IBig::ONE, -143), 1.0 + f64::EPSILON);
        assert_eq!(nearest(IBig::ONE - ((&one + 1) << 90_usize), -143), -1.0);
        assert_eq!((nearest(1.into(), -1075), nearest(3.into(), -1075)), (0.0, 2.0 * SMALLEST));
        assert_eq!(nearest(((IBig::ONE << 54) - IBig::ONE) << 70, 900), f64::INFINITY);
        assert_eq!(nearest((IBig::ONE << 53) - IBig::ONE, 971), f64::MAX);
        // every double is its own nearest one
        for bits in (0..0x7ff0_0000_0000_0000_u64).step_by(0x000f_3a51_77c4_019b) {
            let number = f64::from_bits(bits);
            assert_eq!(Proportion::of_double(number).nearest(), number);
            // a quotient of doubles is rounded to the nearest one
            assert_eq!(Proportion::of_double(number).times(&of(1, 3, 0)).nearest(), number / 3.0);
        }
    }

    #[test]
    fn doubles_near_a_proportion() {
        assert_eq!(of(1, 3, 0).nearest(), 1.0 / 3.0);
        assert_eq!(of(-3, 4, 0).nearest(), -0.75);
        assert_eq!(of(0, 4, 9).nearest(), 0.0);
        let long = Proportion::new(IBig::from(-3) << 5000, IBig::from(4), -4990);
        assert_eq!(long.nearest(), -768.0);
        assert_eq!(of(1, 1, 4000).nearest(), f64::INFINITY);
        assert_eq!(of(1, 1, -4000).nearest(), 0.0);
        assert_eq!(Proportion::of_double(f64::MAX).nearest(), f64::MAX);
        assert_eq!(Proportion::of_double(1e-300).nearest(), 1e-300);
        let wide = Proportion::of_double(f64::MAX).over(&Proportion::of_double(f64::MAX));
        assert_eq!(wide.map(|one| one.nearest()), Some(1.0));
    }

    #[test]
    fn between_the_largest_double_and_half_a_unit_more_both_figures_are_right() {
        let accepts = |claimed: f64, exact: &Proportion| check_figure("it", claimed, exact, &of(0, 1, 0)).is_ok();
        let largest = Proportion::of_double(f64::MAX);
        // a quarter of the unit 2^971 in the last place
        let more = largest.plus(&of(1, 1, 969));
        let less = Proportion::whole(IBig::ZERO, 0).minus(&more);
        assert_eq!((more.nearest(), less.nearest()), (f64::MAX, -f64::MAX));
        assert!(accepts(f64::INFINITY, &more) && !accepts(f64::NEG_INFINITY, &more));
        assert!(accepts(f64::NEG_INFINITY, &less) && !accepts(f64::INFINITY, &less));
        assert!(!accepts(f64::INFINITY, &largest) && !accepts(f64::NAN, &more));
    }

    /// Whole numbers, quotients and powers of two whose roots are known.
    #[test]
    fn roots_by_hand() {
        for (square, root) in [
            (of(0, 1, 0), of(0, 1, 0)),
            (of(9, 1, 0), of(3, 1, 0)),
            (of(1, 4, 0), of(1, 2, 0)),
            (Proportion::whole(IBig::ONE << 299, 1), of(1, 1, 150)),
            (Proportion::whole(IBig::from(49) << 301, -1), of(7, 1, 150)),
        ] {
            assert_eq!(square.root().compare(&root), Ordering::Equal, "{square:?}");
        }
    }

    /// The roots of quotients of numbers of any length have half of 240 bits, and a few more, and are that exact.
    #[test]
    fn roots_have_as_many_bits_as_their_error_needs() {
        let odd = |bits: usize| (IBig::ONE << (bits - 1)) + IBig::ONE;
        for (above, below) in [(1, 1), (1, 100), (100, 1), (100, 100), (230, 3), (3, 230)] {
            let square = Proportion::new(odd(above) + 1, odd(below), 3);
            let root = square.root();
            let bits = root.numerator.bit_len();
            assert!((120..=123).contains(&bits), "{above} / {below}: {bits} bits");
            let error = root.times(&root).minus(&square).magnitude();
            assert_eq!(error.compare(&square.times(&of(1, 1, -100))), Ordering::Less, "{above} / {below}");
        }
    }
}
