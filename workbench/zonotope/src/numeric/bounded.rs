//! Doubles with a bound on their distance from an exact value, for filters of a few operations.
//!
//! Each operation adds its own rounding: u = 2^-53 times the result, and less than 2^-900 for underflow. The bounds
//! themselves are sums and products of a few rounded terms that are not negative, which [`FIVE_ROUNDINGS`] covers.
//! Overflow makes a bound infinite or NaN, and every certain comparison false.

pub(crate) mod wide;

use std::ops::{Add, Mul, Sub};

use super::dyadic::Dyadic;
use super::exact_sum::exact_sum;
use super::linear::{self, ring_of_values};
use super::tolerance::{DIFFERENCE_OF_LEADING_DOUBLES, FIVE_ROUNDINGS, PRODUCT_UNDERFLOW, UNIT};

/// An exact value within `error` of `value`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounded {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// A vector of such values.
pub(crate) type BoundedVector = [Bounded; 3];

impl Bounded {
    /// A double that is the exact value.
    #[inline]
    pub(crate) const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// Whether the exact value is certainly positive.
    #[inline]
    pub(crate) fn is_positive(self) -> bool {
        self.value > self.error
    }

    /// Whether the exact value is certainly smaller in magnitude than another, which is certainly positive.
    #[inline]
    pub(crate) fn is_within(self, limit: Self) -> bool {
        (self.value.abs() + self.error) * FIVE_ROUNDINGS < (limit.value - limit.error) * (2.0 - FIVE_ROUNDINGS)
    }

    /// The sign of the exact value if it is certain and not zero.
    #[inline]
    pub(crate) fn sign(self) -> Option<i8> {
        (self.value.abs() > self.error).then_some(if self.value > 0.0 { 1 } else { -1 })
    }

    /// A bound for the exact value's magnitude.
    #[inline]
    pub(crate) fn magnitude(self) -> f64 {
        (self.value.abs() + self.error) * FIVE_ROUNDINGS
    }

    /// The opposite value.
    #[inline]
    pub(crate) fn negated(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl Add for Bounded {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self { value, error: (self.error + other.error + UNIT * value.abs()) * FIVE_ROUNDINGS }
    }
}

impl Sub for Bounded {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        let value = self.value - other.value;
        Self { value, error: (self.error + other.error + UNIT * value.abs()) * FIVE_ROUNDINGS }
    }
}

impl Mul for Bounded {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let carried = self.value.abs() * other.error + (other.value.abs() + other.error) * self.error;
        Self { value, error: (carried + UNIT * value.abs()) * FIVE_ROUNDINGS + PRODUCT_UNDERFLOW }
    }
}

ring_of_values!(Bounded, Bounded::exact(0.0), Bounded::exact(1.0));

/// A vector of doubles.
#[inline]
pub(crate) fn exact(v: [f64; 3]) -> BoundedVector {
    v.map(Bounded::exact)
}

/// A vector of exact numbers, as its leading doubles.
pub(crate) fn leading(v: &[Dyadic; 3]) -> BoundedVector {
    v.each_ref().map(|coordinate| {
        let value = coordinate.to_f64();
        Bounded { value, error: DIFFERENCE_OF_LEADING_DOUBLES * value.abs() + f64::MIN_POSITIVE }
    })
}

/// A vector that is known but for a part of its length.
pub(crate) fn approximate(v: [f64; 3], relative_error: f64) -> BoundedVector {
    if relative_error == 0.0 {
        return exact(v);
    }
    let error = 2.0 * relative_error * v.iter().map(|c| c.abs()).sum::<f64>();
    v.map(|value| Bounded { value, error })
}

/// The difference `to` − `from` of two vectors of doubles.
#[inline]
pub(crate) fn difference(from: [f64; 3], to: [f64; 3]) -> BoundedVector {
    let difference = |i: usize| {
        let (value, rest) = exact_sum(to[i], -from[i]);
        Bounded { value, error: if rest == 0.0 { 0.0 } else { UNIT * value.abs() } }
    };
    [difference(0), difference(1), difference(2)]
}

/// a × b.
///
/// Of vectors of doubles the bound is that of six products and three differences, which takes half the operations of
/// the bound that carries errors of the coordinates on.
#[inline]
pub(crate) fn cross(a: &BoundedVector, b: &BoundedVector) -> BoundedVector {
    if a.iter().chain(b).any(|c| c.error != 0.0) {
        return linear::cross(a, b);
    }
    let minor = |i: usize, j: usize| {
        let (first, second) = (a[i].value * b[j].value, a[j].value * b[i].value);
        let value = first - second;
        let error = UNIT * (first.abs() + second.abs() + value.abs());
        Bounded { value, error: error * FIVE_ROUNDINGS + 2.0 * PRODUCT_UNDERFLOW }
    };
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// A bound as it is, infinite where it is NaN.
pub(crate) fn finite_or_infinity(bound: f64) -> f64 {
    if bound.is_finite() { bound } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear;
    use crate::numeric::linear::dot;
    use crate::numeric::scaling::{power_of_two, scale_by_power_of_two};
    use proptest::prelude::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    properties! {
        #[test]
        fn bounds_hold(bits in proptest::array::uniform9(any::<u64>()), small in any::<bool>()) {
            let value = |bits: u64| {
                let v = f64::from_bits(bits);
                if !v.is_finite() { 0.5 } else if small { v % 8.0 } else { v }
            };
            let rows: [[f64; 3]; 3] = [0, 3, 6].map(|i| [0, 1, 2].map(|k| value(bits[i + k])));
            let [a, b, c] = rows.map(exact);
            let rounded = dot(&cross(&a, &b), &c);
            let [a, b, c] = rows.map(exact_linear::exact);
            let truth = dot(&exact_linear::cross(&a, &b), &c);
            if rounded.error.is_finite() && rounded.value.is_finite() {
                let off = (truth.clone() - Dyadic::from_f64(rounded.value)).abs();
                prop_assert!(off <= Dyadic::from_f64(rounded.error));
                if let Some(sign) = rounded.sign() {
                    prop_assert_eq!(sign, truth.sign() as i8);
                }
            }
        }
    }

    /// A double near 1, near 0, subnormal, large, or a small whole number.
    pub(super) fn double(rng: &mut Pcg64Mcg) -> f64 {
        let exponent = match rng.random_range(0..8) {
            0 => return f64::from(rng.random_range(-3i32..4)),
            1 => rng.random_range(-1074..-960),
            2 => rng.random_range(300..500),
            3 => rng.random_range(-600..300),
            _ => rng.random_range(-4..4),
        };
        scale_by_power_of_two(rng.random_range(-2.0..2.0), exponent)
    }

    /// A double that is exact or off by 2^-60 to 2^-3 of itself, at times by as much as it is large.
    pub(super) fn operand(rng: &mut Pcg64Mcg) -> Bounded {
        let value = double(rng);
        let error = match rng.random_range(0..8) {
            0..3 => 0.0,
            3 => value.abs() * rng.random_range(0.5..1.5),
            4 => double(rng).abs(),
            _ => value.abs() * power_of_two(rng.random_range(-60..-2)),
        };
        Bounded { value, error }
    }

    fn vector(draw: impl FnMut(usize) -> Bounded) -> BoundedVector {
        std::array::from_fn(draw)
    }

    /// The exact values at both ends of the bound, and the double itself.
    pub(super) fn ends(x: &Bounded) -> [Dyadic; 3] {
        [-x.error, 0.0, x.error].map(|off| Dyadic::from_f64(x.value) + Dyadic::from_f64(off))
    }

    /// The results of an operation on each pair of exact values within the bounds of its operands.
    pub(super) fn pairs(x: &Bounded, y: &Bounded, operation: impl Fn(&Dyadic, &Dyadic) -> Dyadic) -> Vec<Dyadic> {
        let others = ends(y);
        ends(x).iter().flat_map(|x| others.each_ref().map(|y| operation(x, y))).collect()
    }

    /// Holds a result to the exact values that it may have: each is within the bound, which is at most four times the
    /// distance of the farthest one, the rounding of numbers of a size, and what may underflow.
    fn is_good(result: &Bounded, exact: &[Dyadic], size: &Dyadic) {
        let value = Dyadic::from_f64(result.value);
        let farthest = exact.iter().map(|exact| (exact - &value).abs()).max().expect("there is an exact value");
        let error = Dyadic::from_f64(result.error);
        assert!(farthest <= error, "{result:?} is off by {:e}", farthest.to_f64());
        let allowed = &(&farthest + &size.clone().scaled(-53)) + &Dyadic::from_f64(PRODUCT_UNDERFLOW);
        assert!(error <= allowed.scaled(2), "{result:?} is off by {:e} alone", farthest.to_f64());
    }

    #[test]
    fn bounds_hold_and_are_at_most_four_times_what_the_operands_explain() {
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        for _ in 0..4000 {
            let (x, y) = (operand(&mut rng), operand(&mut rng));
            for (result, exact) in [
                (x + y, pairs(&x, &y, |x, y| x + y)),
                (x - y, pairs(&x, &y, |x, y| x - y)),
                (x * y, pairs(&x, &y, |x, y| x * y)),
            ] {
                is_good(&result, &exact, &Dyadic::from_f64(result.value).abs());
            }
        }
    }

    #[test]
    fn cross_products_hold_and_are_good_with_errors_and_without() {
        let mut rng = Pcg64Mcg::seed_from_u64(2);
        for round in 0..1500 {
            let scale = scale_by_power_of_two(1.0, if round % 3 == 0 { -480 } else { 0 });
            let [a, b] = [(); 2].map(|()| {
                vector(|_| {
                    let value = rng.random_range(-2.0..2.0) * scale;
                    let part = if round % 2 == 0 { 0.0 } else { power_of_two(rng.random_range(-60..-2)) };
                    Bounded { value, error: value.abs() * part }
                })
            });
            let result = cross(&a, &b);
            for (k, (i, j)) in [(1, 2), (2, 0), (0, 1)].into_iter().enumerate() {
                let [first, second] = [(i, j), (j, i)].map(|(i, j)| pairs(&a[i], &b[j], |x, y| x * y));
                let exact: Vec<_> = first.iter().flat_map(|x| second.iter().map(move |y| x - y)).collect();
                let size = &ends(&a[i])[1] * &ends(&b[j])[1];
                is_good(&result[k], &exact, &(size.abs() + (&ends(&a[j])[1] * &ends(&b[i])[1]).abs()));
            }
        }
    }

    #[test]
    fn comparisons_tell_what_holds_within_the_bounds_and_little_less() {
        let mut rng = Pcg64Mcg::seed_from_u64(3);
        for round in 0..4000 {
            let limit = operand(&mut rng);
            let near = 1.0 + power_of_two(rng.random_range(-52..-2));
            let x = match round % 3 {
                0 => operand(&mut rng),
                1 => Bounded { value: (limit.value - limit.error) / near, error: 0.0 },
                _ => Bounded { value: (limit.value - limit.error) * near, error: 0.0 },
            };
            let [lowest, _, highest] = ends(&x);
            let largest = lowest.clone().abs().max(highest.clone().abs());
            let [least, ..] = ends(&limit);
            let nearly = &largest + &largest.clone().scaled(-48);
            assert!(!x.is_within(limit) || largest < least, "{x:?} {limit:?}");
            assert!(x.is_within(limit) || nearly >= least, "{x:?} {limit:?}");
            let magnitude = Dyadic::from_f64(x.magnitude());
            assert!(largest <= magnitude && magnitude <= nearly, "{x:?}");
            assert_eq!(x.is_positive(), lowest > Dyadic::zero(), "{x:?}");
            let sign = if lowest.sign() == highest.sign() { lowest.sign() as i8 } else { 0 };
            assert_eq!(x.sign(), (sign != 0).then_some(sign), "{x:?}");
        }
    }

    #[test]
    fn what_may_be_zero_is_not_told_from_it() {
        let [zero, touching] = [Bounded::exact(0.0), Bounded { value: 1.0, error: 1.0 }];
        for value in [zero, touching, touching.negated()] {
            assert!(!value.is_positive() && value.sign().is_none(), "{value:?}");
            assert!(!zero.is_within(value), "{value:?}");
        }
    }

    #[test]
    fn differences_of_doubles_are_exact_where_they_are_doubles() {
        let mut rng = Pcg64Mcg::seed_from_u64(4);
        for _ in 0..2000 {
            let [from, to] = [(); 2].map(|()| [(); 3].map(|()| double(&mut rng)));
            for (k, result) in difference(from, to).iter().enumerate() {
                let exact = Dyadic::from_f64(to[k]) - Dyadic::from_f64(from[k]);
                is_good(result, std::slice::from_ref(&exact), &exact.clone().abs());
                assert_eq!(result.error == 0.0, exact == Dyadic::from_f64(result.value), "{result:?}");
            }
        }
    }

    #[test]
    fn leading_doubles_are_near_exact_numbers_of_all_sizes() {
        let mut rng = Pcg64Mcg::seed_from_u64(5);
        for _ in 0..1000 {
            let exact = [(); 3].map(|()| Dyadic::from_f64(double(&mut rng)) * Dyadic::from_f64(double(&mut rng)));
            for (result, exact) in leading(&exact).iter().zip(&exact) {
                let off = (exact - &Dyadic::from_f64(result.value)).abs();
                let error = Dyadic::from_f64(result.error);
                let most = exact.clone().abs().scaled(-47) + Dyadic::from_f64(f64::MIN_POSITIVE).scaled(1);
                assert!(off <= error && error <= most, "{result:?}");
            }
        }
    }

    #[test]
    fn vectors_known_but_for_a_part_of_their_length_are_off_by_it() {
        let vector = [3.0, -4.0, 12.0];
        assert!(approximate(vector, 0.0).iter().all(|coordinate| coordinate.error == 0.0));
        for part in [-60, -30, -3].map(power_of_two) {
            for (coordinate, value) in approximate(vector, part).iter().zip(vector) {
                assert_eq!(coordinate.value, value);
                // The length is 13, that of the exact vector at most 13 / (1 − part).
                assert!((13.0 * part / (1.0 - part)..=52.0 * part).contains(&coordinate.error), "{coordinate:?}");
            }
        }
    }

    #[test]
    fn bounds_that_are_no_numbers_are_infinite() {
        assert_eq!([f64::NAN, f64::INFINITY].map(finite_or_infinity), [f64::INFINITY; 2]);
        assert_eq!(finite_or_infinity(1.5), 1.5);
    }
}
