//! Doubles with a bound on their distance from an exact value, times a power of two of their own, for filters of a few
//! operations on numbers of all sizes.
//!
//! A product of three coordinates leaves the range of doubles where they are as large as 2^342 or as small as 2^−342,
//! and then [`Bounded`] decides nothing. Here the doubles stay between 2^−[`LARGEST_EXPONENT`] and its inverse, so that
//! what they lose is as in [`Bounded`]: u = 2^-53 times each result, and less than 2^-900 for underflow of a bound.

use std::ops::{Add, Mul, Sub};

use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::ring_of_values;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::{DIFFERENCE_OF_LEADING_DOUBLES, FIVE_ROUNDINGS, PRODUCT_UNDERFLOW, UNIT};

/// The exact value is 2^`exponent` times one that `part` bounds; its double is 0 or has an exponent of
/// [`LARGEST_EXPONENT`] at most in magnitude.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BoundedWide {
    part: Bounded,
    exponent: i64,
}

/// A double of which the exponent exceeds this in magnitude is scaled to about 1.
const LARGEST_EXPONENT: i32 = 100;

/// Of two summands whose powers of two are further apart than this, the smaller one is only an error.
const NEGLIGIBLE_DISTANCE: i64 = 400;

impl BoundedWide {
    const ZERO: Self = Self { part: Bounded::exact(0.0), exponent: 0 };

    /// A finite double that is the exact value.
    pub(crate) fn exact(value: f64) -> Self {
        Self::normalized(Bounded::exact(value), 0)
    }

    /// An exact number.
    pub(crate) fn of(number: &Dyadic) -> Self {
        let (value, exponent) = number.leading();
        Self::normalized(Bounded { value, error: DIFFERENCE_OF_LEADING_DOUBLES * value.abs() }, exponent)
    }

    /// The sum of two finite doubles.
    pub(crate) fn of_sum([head, tail]: [f64; 2]) -> Self {
        Self::exact(head) + Self::exact(tail)
    }

    /// The sign of the exact value if it is certain and not zero.
    pub(crate) fn sign(self) -> Option<i8> {
        self.part.sign()
    }

    /// The opposite value.
    pub(crate) fn negated(self) -> Self {
        Self { part: self.part.negated(), ..self }
    }

    /// The number with its double scaled to about 1 where it is far from it.
    fn normalized(part: Bounded, exponent: i64) -> Self {
        match binary_exponent(part.value) {
            None if part.error == 0.0 => Self::ZERO,
            Some(own) if own.abs() > LARGEST_EXPONENT => {
                // A denormal double becomes a normal one without rounding. The bound may round, or vanish.
                let [value, error] = [part.value, part.error].map(|v| scale_by_power_of_two(v, -i64::from(own)));
                let error = if part.error == 0.0 { 0.0 } else { error * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW };
                Self { part: Bounded { value, error }, exponent: exponent + i64::from(own) }
            }
            _ => Self { part, exponent },
        }
    }

    fn is_zero(&self) -> bool {
        self.part.value == 0.0 && self.part.error == 0.0
    }

    /// The part in units of a power of two that is no less than its own.
    fn in_units_of(&self, exponent: i64) -> Bounded {
        let down = self.exponent - exponent;
        if down == 0 {
            return self.part;
        }
        if down < -NEGLIGIBLE_DISTANCE {
            let largest = scale_by_power_of_two(self.part.magnitude(), -NEGLIGIBLE_DISTANCE);
            return Bounded { value: 0.0, error: largest * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW };
        }
        // The double is far from the least normal one, the bound may not be.
        let [value, error] = [self.part.value, self.part.error].map(|v| scale_by_power_of_two(v, down));
        let error = if self.part.error == 0.0 { 0.0 } else { error * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW };
        Bounded { value, error }
    }
}

impl BoundedWide {
    fn plus(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let exponent = self.exponent.max(other.exponent);
        let [a, b] = [self, other].map(|summand| summand.in_units_of(exponent));
        let value = a.value + b.value;
        let error = (a.error + b.error + UNIT * value.abs()) * FIVE_ROUNDINGS;
        Self::normalized(Bounded { value, error }, exponent)
    }
}

impl Add for BoundedWide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl Sub for BoundedWide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.plus(other.negated())
    }
}

impl Mul for BoundedWide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        Self::normalized(self.part * other.part, self.exponent + other.exponent)
    }
}

ring_of_values!(BoundedWide, BoundedWide::ZERO, BoundedWide { part: Bounded::exact(1.0), exponent: 0 });

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::bounded::tests::{ends, operand, pairs};
    use crate::numeric::exact_linear;
    use crate::numeric::linear::{cross, dot};
    use crate::numeric::scaling::power_of_two;
    use proptest::prelude::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// A double of any size, often at an end of the range, zero, or one more than a power of two.
    fn double(bits: u64) -> f64 {
        let value = f64::from_bits(bits);
        match bits % 8 {
            _ if !value.is_finite() => f64::MAX,
            0 => 0.0,
            1 => f64::from_bits(bits % 1024 + 1),
            2 => f64::from_bits(bits & !0xf_ffff_ffff_ffff),
            3 => (value % 16.0).trunc(),
            _ => value,
        }
    }

    properties! {
        #![proptest_config(crate::property_cases::config(4096))]

        #[test]
        fn bounds_hold_for_numbers_of_all_sizes(bits in proptest::array::uniform9(any::<u64>())) {
            let rows: [[f64; 3]; 3] = [0, 3, 6].map(|i| [0, 1, 2].map(|k| double(bits[i + k])));
            let exactly = rows.map(exact_linear::exact);
            let truth = dot(&exact_linear::cross(&exactly[0], &exactly[1]), &exactly[2]);
            let [a, b, c] = rows.map(|row| row.map(BoundedWide::exact));
            let wide = dot(&cross(&a, &b), &c);
            let off = (truth.clone() - Dyadic::from_f64(wide.part.value).scaled(wide.exponent)).abs();
            prop_assert!(off <= Dyadic::from_f64(wide.part.error).scaled(wide.exponent), "{rows:?} {wide:?}");
            if let Some(sign) = wide.sign() {
                prop_assert_eq!(sign, truth.sign() as i8);
            }
            let of_truth = BoundedWide::of(&truth);
            prop_assert!(truth.is_zero() || of_truth.sign() == Some(truth.sign() as i8), "{of_truth:?}");
            let sum = BoundedWide::of_sum([rows[0][0], rows[0][1]]);
            let off = (&exactly[0][0] + &exactly[0][1]) - Dyadic::from_f64(sum.part.value).scaled(sum.exponent);
            prop_assert!(off.abs() <= Dyadic::from_f64(sum.part.error).scaled(sum.exponent), "{sum:?}");
        }
    }

    #[test]
    fn determinants_far_beyond_the_doubles_have_their_sign() {
        let [least, most] = [f64::from_bits(1), f64::MAX].map(BoundedWide::exact);
        assert_eq!((least * least * least).sign(), Some(1));
        assert_eq!((most * most * most - least).sign(), Some(1));
        assert_eq!((least * least - most * most).sign(), Some(-1));
        assert_eq!((most - most).sign(), None);
        assert_eq!((BoundedWide::ZERO * most + least).sign(), Some(1));
    }

    /// A number whose double is near 1 or 0, with an error that is none, a part of it, tiny or large.
    fn wide(rng: &mut Pcg64Mcg) -> BoundedWide {
        let value = if rng.random_ratio(1, 3) { 0.0 } else { scale_by_power_of_two(1.5, rng.random_range(-100..101)) };
        let error = match rng.random_range(0..4) {
            0 => 0.0,
            1 => power_of_two([-950, -899, -600, 0][rng.random_range(0..4)]),
            _ => value.abs() * power_of_two(rng.random_range(-60..-2)),
        };
        let exponent = [0, 0, 1, -200, 300, 400, 401, 500, -5000][rng.random_range(0..9)];
        BoundedWide { part: Bounded { value: if rng.random() { value } else { -value }, error }, exponent }
    }

    /// Holds a result to the exact values that it may have: each is within the bound, which is at most four times the
    /// distance of the farthest one, one rounding, and what may vanish.
    fn is_good(result: &BoundedWide, exact: &[Dyadic], vanishing: &Dyadic) {
        let scaled = |v: f64| Dyadic::from_f64(v).scaled(result.exponent);
        let (value, error) = (scaled(result.part.value), scaled(result.part.error));
        let farthest = exact.iter().map(|exact| (exact - &value).abs()).max().expect("there is an exact value");
        assert!(farthest <= error, "{result:?}");
        let allowed = &(&farthest + &value.abs().scaled(-53)) + vanishing;
        assert!(error <= allowed.scaled(2), "{result:?}");
    }

    #[test]
    fn bounds_are_at_most_four_times_what_the_operands_explain() {
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        for _ in 0..5000 {
            let (x, y) = (wide(&mut rng), wide(&mut rng));
            let exactly = |operation: fn(&Dyadic, &Dyadic) -> Dyadic| {
                let scaled = |v: &Dyadic, of: &BoundedWide| v.clone().scaled(of.exponent);
                pairs(&x.part, &y.part, |v, w| operation(&scaled(v, &x), &scaled(w, &y)))
            };
            // A summand that is 2^-400 of a double of at most 2^101 is only an error.
            let negligible = Dyadic::one().scaled(x.exponent.max(y.exponent) - 298);
            is_good(&(x + y), &exactly(|v, w| v + w), &negligible);
            is_good(&(x - y), &exactly(|v, w| v - w), &negligible);
            is_good(&(x * y), &exactly(|v, w| v * w), &Dyadic::one().scaled(x.exponent + y.exponent - 899));
        }
    }

    #[test]
    fn numbers_of_all_sizes_are_scaled_within_their_bounds() {
        let mut rng = Pcg64Mcg::seed_from_u64(2);
        for _ in 0..4000 {
            let part = operand(&mut rng);
            if part.error > part.value.abs() * 2.0 {
                continue;
            }
            let result = BoundedWide::normalized(part, 7);
            let exact = ends(&part).map(|end| end.scaled(7));
            is_good(&result, &exact, &Dyadic::one().scaled(result.exponent - 899));
            assert_eq!(result.part.error == 0.0, part.error == 0.0, "{part:?}");
        }
    }

    #[test]
    fn doubles_keep_their_exponent_up_to_the_largest_one() {
        for (own, exponent) in [(100, 0), (101, 101), (-100, 0), (-101, -101), (0, 0)] {
            let number = BoundedWide::exact(power_of_two(own));
            assert_eq!((number.exponent, number.part.error), (exponent, 0.0), "{own}");
            assert_eq!(number.part.value, power_of_two(own - exponent as i32), "{own}");
        }
    }

    #[test]
    fn zero_has_one_form() {
        let shifted = BoundedWide::of(&Dyadic::zero().scaled(9));
        for zero in [BoundedWide::exact(0.0), shifted, BoundedWide::normalized(Bounded::exact(0.0), 7)] {
            assert_eq!((zero.part.value, zero.part.error, zero.exponent), (0.0, 0.0, 0));
        }
    }

    #[test]
    fn what_cancels_is_not_zero_but_within_its_bound() {
        let [a, b] = [0.1, 0.3].map(BoundedWide::exact);
        let cancelled = a * b - a * b;
        assert!(!cancelled.is_zero() && cancelled.sign().is_none());
        assert_eq!((cancelled * BoundedWide::exact(f64::MAX) + b).sign(), None);
        assert_eq!((a - a).sign(), None);
    }

    #[test]
    fn summands_are_only_errors_beyond_the_negligible_distance() {
        let doubt = BoundedWide { part: Bounded { value: 0.0, error: power_of_two(-899) }, exponent: 0 };
        for (distance, sign) in [(399, Some(1)), (400, Some(1)), (401, None)] {
            let one = BoundedWide { part: Bounded::exact(1.0), exponent: -distance };
            assert_eq!((doubt + one).sign(), sign, "{distance}");
        }
    }
}
