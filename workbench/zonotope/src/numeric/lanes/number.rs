//! What a pass computes with: eight numbers in lanes, or one.
//!
//! A pass reads eight generators at a time, and those that are left one by one: to fill up an octet with zeros takes
//! stores and loads that wait for each other, which is most of the time of a pass over a few generators. So the steps
//! of a pass are written once, for numbers of either kind.

use std::ops::{Add, AddAssign, Div, Mul, Sub};

use fearless_simd::{Simd, f64x8, prelude::*};

/// A double, or eight of them side by side.
pub(crate) trait Number:
    Copy + Add<Output = Self> + AddAssign + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The magnitude.
    fn magnitude(self) -> Self;

    /// The larger of two numbers that are not NaN.
    fn larger(self, other: Self) -> Self;

    /// This number with the sign of another.
    fn signed_as(self, other: Self) -> Self;

    /// One of two numbers: the first if this one is less than a limit, the second if it is not, or is NaN.
    fn if_less(self, limit: Self, then: Self, otherwise: Self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn magnitude(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn signed_as(self, other: Self) -> Self {
        self.copysign(other)
    }

    #[inline(always)]
    fn if_less(self, limit: Self, then: Self, otherwise: Self) -> Self {
        if self < limit { then } else { otherwise }
    }
}

impl<S: Simd> Number for f64x8<S> {
    #[inline(always)]
    fn magnitude(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn signed_as(self, other: Self) -> Self {
        self.copysign(other)
    }

    #[inline(always)]
    fn if_less(self, limit: Self, then: Self, otherwise: Self) -> Self {
        self.simd_lt(limit).select(then, otherwise)
    }
}

/// v · u.
#[inline(always)]
pub(crate) fn product<T: Number>(v: &[T; 3], u: &[T; 3]) -> T {
    v[0] * u[0] + v[1] * u[1] + v[2] * u[2]
}

/// The largest magnitude of a coordinate, and at least the smallest normal number: for divisions.
#[inline(always)]
pub(crate) fn size<T: Number>(v: &[T; 3], units: &Units<T>) -> T {
    v[0].magnitude().larger(v[1].magnitude()).larger(v[2].magnitude()).larger(units.least)
}

/// A number clipped to [−limit, limit].
#[inline(always)]
pub(crate) fn clipped<T: Number>(x: T, limit: T) -> T {
    x.magnitude().if_less(limit, x, limit.signed_as(x))
}

/// The rounded sum, and what rounding leaves behind (Knuth).
#[inline(always)]
pub(crate) fn sum_and_rest<T: Copy + Add<Output = T> + Sub<Output = T>>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_in_sum = sum - a;
    (sum, (a - (sum - b_in_sum)) + (b - b_in_sum))
}

/// Constants of a pass.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units<T> {
    pub(crate) zero: T,
    pub(crate) one: T,
    /// The smallest normal number.
    pub(crate) least: T,
}

impl Units<f64> {
    /// For generators one by one.
    pub(crate) const SINGLE: Self = Self { zero: 0.0, one: 1.0, least: f64::MIN_POSITIVE };
}

impl<S: Simd> Units<f64x8<S>> {
    /// For eight generators at a time.
    #[inline(always)]
    pub(crate) fn wide(simd: S) -> Self {
        let [zero, one, least] = [0.0, 1.0, f64::MIN_POSITIVE];
        Self { zero: f64x8::splat(simd, zero), one: f64x8::splat(simd, one), least: f64x8::splat(simd, least) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_less_than_a_limit_or_not() {
        assert_eq!([0.5, 1.0, 2.0, f64::NAN].map(|x| x.if_less(1.0, 3.0, 4.0)), [3.0, 4.0, 4.0, 4.0]);
        assert_eq!([0.5, -1.0, 2.0, -3.0].map(|x| clipped(x, 1.0)), [0.5, -1.0, 1.0, -1.0]);
    }
}
