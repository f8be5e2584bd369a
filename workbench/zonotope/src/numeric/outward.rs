//! Directed rounding, and what rounding lost as generators along the axes.
//!
//! A vector that is off by at most r_k in coordinate k lies in the box Σ [−1, 1] r_k e_k around the exact one. So a
//! zonotope whose centre and generators were rounded contains the exact one as soon as a generator r_k e_k is added
//! along each axis, r_k the sum of what was lost there.

use super::Rational;
use super::double_double::{BoundedDoubleDouble, DoubleDouble};
use super::dyadic::Dyadic;

/// The least double that is not below an exact number; infinite above the largest double.
pub(crate) fn at_least(exact: &Dyadic) -> f64 {
    least_upper(exact.to_f64(), |value| Dyadic::from_f64(value) < *exact)
}

/// The greatest double that is not above an exact number; negative infinity below the lowest double.
pub(crate) fn at_most(exact: &Dyadic) -> f64 {
    0.0 - at_least(&-exact.clone())
}

/// The least double that is not below the exact value that a pair of doubles is near, if its bound tells which one it
/// is.
pub(crate) fn certain_at_least(value: &BoundedDoubleDouble) -> Option<f64> {
    let nearest = value.nearest_double()?;
    let (DoubleDouble { low, .. }, _) = value.parts();
    match value.is_no_double() {
        true => Some(if low > 0.0 { nearest.next_up() } else { nearest }),
        false => value.is_exactly_double().then_some(nearest + 0.0),
    }
}

/// The greatest double that is not above the exact value that a pair of doubles is near, if its bound tells which one
/// it is.
pub(crate) fn certain_at_most(value: &BoundedDoubleDouble) -> Option<f64> {
    certain_at_least(&value.negated()).map(|least| 0.0 - least)
}

/// A double that is not below a fraction and within a few units in the last place of it; infinite above the largest
/// one.
///
/// The search goes up alone, from a quotient whose last bits are not certain: the numbers of a fraction are long, and
/// each comparison with it costs more than these bits are worth.
pub(crate) fn fraction_at_least(exact: &Rational) -> f64 {
    let mut value = exact.to_f64_fast().clamp(f64::MIN, f64::MAX);
    while value.is_finite() && Dyadic::from_f64(value).to_rational() < *exact {
        value = value.next_up();
    }
    value + 0.0
}

/// A double that is not above a fraction and within a few units in the last place of it; negative infinity below the
/// lowest one. The search goes down alone.
pub(crate) fn fraction_at_most(exact: &Rational) -> f64 {
    let mut value = exact.to_f64_fast().clamp(f64::MIN, f64::MAX);
    while value.is_finite() && Dyadic::from_f64(value).to_rational() > *exact {
        value = value.next_down();
    }
    value + 0.0
}

/// The least double that is not below a number, from a double near it.
fn least_upper(near: f64, is_below: impl Fn(f64) -> bool) -> f64 {
    let mut value = near.clamp(f64::MIN, f64::MAX);
    while is_below(value) {
        value = value.next_up();
        if value == f64::INFINITY {
            return value;
        }
    }
    while value > f64::MIN && !is_below(value.next_down()) {
        value = value.next_down();
    }
    // the double above the smallest negative one is −0
    value + 0.0
}

/// The next double above one that is not negative, where 0 is known to be exact and stays.
pub(crate) fn above(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.next_up() }
}

/// The least double of so many leading bits that is not below a positive normal one; infinite above the largest.
pub(crate) fn with_leading_bits_at_least(value: f64, bits: u32) -> f64 {
    let rest = (1u64 << (f64::MANTISSA_DIGITS - bits)) - 1;
    f64::from_bits((value.to_bits() + rest) & !rest)
}

/// The generators of a box of given half-lengths, one along each axis in which there is one.
pub(crate) fn axis_generators<const D: usize>(half_lengths: [f64; D]) -> impl Iterator<Item = [f64; D]> {
    let along = |(axis, half): (usize, f64)| {
        let mut generator = [0.0; D];
        generator[axis] = half;
        generator
    };
    half_lengths.into_iter().enumerate().filter(|&(_, half)| half != 0.0).map(along)
}

/// What rounding lost, coordinate by coordinate.
#[derive(Debug, Clone)]
pub(crate) struct Loss<const D: usize>([Dyadic; D]);

impl<const D: usize> Loss<D> {
    /// Nothing was lost yet.
    pub(crate) fn none() -> Self {
        Self(std::array::from_fn(|_| Dyadic::zero()))
    }

    /// Rounds a vector and adds up by how much; infinite coordinates where the range of doubles ends.
    pub(crate) fn round(&mut self, exact: &[Dyadic; D]) -> [f64; D] {
        std::array::from_fn(|k| {
            let rounded = exact[k].to_f64();
            if rounded.is_finite() {
                self.0[k] = &self.0[k] + &(&exact[k] - &Dyadic::from_f64(rounded)).abs();
            }
            rounded
        })
    }

    /// Adds up a further loss along an axis.
    pub(crate) fn widen(&mut self, axis: usize, by: &Dyadic) {
        self.0[axis] = &self.0[axis] + by;
    }

    /// The generators that make up for it, along each axis that lost something.
    pub(crate) fn generators(&self) -> impl Iterator<Item = [f64; D]> {
        axis_generators(self.0.each_ref().map(at_least))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn extremes_are_rounded_outward() {
        let (largest, smallest) = (Dyadic::from_f64(f64::MAX), Dyadic::from_f64(f64::from_bits(1)));
        assert_eq!(at_least(&largest), f64::MAX);
        assert_eq!(at_least(&(&largest + &smallest)), f64::INFINITY);
        assert_eq!(at_least(&-(&largest + &largest)), f64::MIN);
        assert_eq!(at_most(&(&largest + &largest)), f64::MAX);
        assert_eq!(at_least(&smallest.clone().scaled(-1)), f64::from_bits(1));
        assert_eq!(at_most(&smallest.scaled(-1)).to_bits(), 0);
        assert_eq!(at_least(&Dyadic::zero()).to_bits(), 0);
        let third = Rational::from_parts(1.into(), 3u8.into());
        assert!(fraction_at_most(&third) < fraction_at_least(&third));
        let huge = (&largest + &largest).to_rational();
        assert_eq!((fraction_at_most(&huge), fraction_at_least(&huge)), (f64::MAX, f64::INFINITY));
        assert_eq!((above(0.0), above(1.0)), (0.0, 1.0 + f64::EPSILON));
    }

    #[test]
    fn zeros_have_no_sign() {
        let below = Dyadic::one().scaled(-1200);
        assert_eq!(at_least(&-below.clone()).to_bits(), 0);
        assert_eq!(fraction_at_least(&-below.to_rational()).to_bits(), 0);
        assert_eq!(fraction_at_most(&below.to_rational()).to_bits(), 0);
        for zero in [0.0, -0.0].map(BoundedDoubleDouble::exact) {
            assert_eq!([certain_at_least(&zero), certain_at_most(&zero)].map(|v| v.map(f64::to_bits)), [Some(0); 2]);
        }
    }

    #[test]
    fn fractions_that_are_small_whole_numbers_stay() {
        for number in [-3.0, -1.0, 0.0, 0.5, 2.0] {
            let fraction = Dyadic::from_f64(number).to_rational();
            assert_eq!([fraction_at_most(&fraction), fraction_at_least(&fraction)], [number; 2]);
        }
    }

    #[test]
    fn the_least_double_that_is_not_below_is_found_from_either_side() {
        for steps in -3..4 {
            let near = 1.0 + f64::from(steps) * f64::EPSILON;
            assert_eq!(least_upper(near, |value| value < 1.0), 1.0);
        }
    }

    #[test]
    fn few_bits_are_rounded_up() {
        let cases = [(1.0, 1.0), (1.25, 1.25), (1.25f64.next_up(), 1.5), (1.75f64.next_up(), 2.0)];
        assert_eq!(cases.map(|(value, _)| with_leading_bits_at_least(value, 3)), cases.map(|(_, rounded)| rounded));
        assert_eq!(with_leading_bits_at_least(f64::MAX, 32), f64::INFINITY);
        assert_eq!(with_leading_bits_at_least(0.1, 53), 0.1);
    }

    #[test]
    fn pairs_without_an_error_are_rounded_for_certain() {
        let half_place = f64::EPSILON / 2.0;
        for (tail, below, above) in [
            (0.0, 1.0, 1.0),
            (half_place, 1.0, 1.0 + f64::EPSILON),
            (1e-30, 1.0, 1.0 + f64::EPSILON),
            (-1e-30, 1f64.next_down(), 1.0),
        ] {
            let pair = BoundedDoubleDouble::of_parts(1.0, tail, 0.0);
            assert_eq!((certain_at_most(&pair), certain_at_least(&pair)), (Some(below), Some(above)), "{tail:e}");
            assert_eq!((pair.is_no_double(), pair.nearest_double()), (tail != 0.0, Some(1.0)));
        }
        let open = BoundedDoubleDouble::of_parts(1.0, 1e-30, 1e-29);
        assert_eq!((certain_at_least(&open), open.is_no_double(), open.nearest_double()), (None, false, Some(1.0)));
    }

    #[test]
    fn what_was_lost_is_a_box() {
        let (one, part) = (Dyadic::one(), Dyadic::one().scaled(-60));
        let mut loss = Loss::none();
        assert_eq!(loss.round(&[one.clone(), &one + &part, -(&one - &part)]), [1.0, 1.0, -1.0]);
        loss.round(&[one.clone(), &one + &part, Dyadic::zero()]);
        let lost = part.to_f64();
        assert_eq!(loss.generators().collect::<Vec<_>>(), [[0.0, 2.0 * lost, 0.0], [0.0, 0.0, lost]]);
        assert_eq!(axis_generators([0.0, 0.0]).count(), 0);
        loss.widen(1, &one);
        let wider = [[0.0, (1.0 + 2.0 * lost).next_up(), 0.0], [0.0, 0.0, lost]];
        assert_eq!(loss.generators().collect::<Vec<_>>(), wider);
    }

    properties! {
        #[test]
        fn the_nearest_double_on_that_side(a in -4.0..4.0f64, b in -1.0..1.0f64, shift in -1100i64..900) {
            let exact = (Dyadic::from_f64(a) * Dyadic::from_f64(b)).scaled(shift);
            let (low, high) = (at_most(&exact), at_least(&exact));
            prop_assert!(Dyadic::from_f64(low) <= exact && exact <= Dyadic::from_f64(high));
            prop_assert!(low == high || low.next_up() == high || (low == 0.0 && high == f64::from_bits(1)));
            for (certain, right) in [
                (certain_at_least(&BoundedDoubleDouble::of(&exact)), high),
                (certain_at_most(&BoundedDoubleDouble::of(&exact)), low),
            ] {
                prop_assert!(certain.is_none_or(|double| double == right));
            }
            let fraction = exact.to_rational();
            let (below, above) = (fraction_at_most(&fraction), fraction_at_least(&fraction));
            prop_assert!(below <= low && high <= above);
            prop_assert!(above - below <= 8.0 * f64::EPSILON * high.abs().max(low.abs()) + 8.0 * f64::from_bits(1));
        }
    }
}
