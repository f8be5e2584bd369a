//! Signs of cross products of planar vectors, by a float filter backed by exact arithmetic: the sign returned is that
//! of the real number, for every finite double.
//!
//! # Statement
//! [`orientation`] decides on which side of the directed line ab the point c lies: the sign of (b − a) × (c − a).
//! [`cross_sign`] decides the turn from the edge ab to the edge cd: the sign of (b − a) × (d − c).
//! Coordinates must be finite; they may be denormal, near overflow, or of very different magnitudes in one call.
//! Points that coincide and parallel edges give [`Turn::Straight`].
//!
//! # Source
//! The filter is Shewchuk's (Adaptive precision floating-point arithmetic, 1997, orientation test, stage A) with a term
//! for underflow. The paper assumes real arithmetic.
//!
//! # Method
//! 1. Filter: compute the two products l, r in doubles and accept the sign of l − r when |l − r| exceeds the error
//!    bound.
//! 2. Parallel test: if the exact edges (head plus tail) are equal or opposite, the turn is straight. Hulls that are
//!    centrally symmetric about the origin end here.
//! 3. Scale by a power of two such that every nonzero magnitude is in [2^-400, 2^480], where that is exact. If both
//!    edges are then doubles, compare the two products, each as an unevaluated sum of two doubles; otherwise Shewchuk's
//!    expansions (crate `robust`).
//! 4. Exact binary integers ([`Dyadic`]) for what cannot be scaled (magnitudes that span more than 2^879).
//!
//! # Complexity
//! Constant time and space. The filter costs 4 subtractions, 2 products and 4 further operations; it fails on
//! points that are collinear or nearly so. The later a step, the more it costs.
//!
//! # Shapes
//! Points are `[f64; 2]`, x first.
//!
//! # Numerics
//! Bound of the filter, u = 2^-53. Each difference is exact up to a factor 1 + δ, |δ| ≤ u (sums have no underflow
//! error); each product has a factor 1 + δ more and an absolute error of at most 2^-1075. Hence l and r have relative
//! error at most 3u + 3u² + u³ before that absolute error, and l − r one more rounding u·|l − r|. If |l − r| > (3u +
//! 16u²)·(|l| + |r|) + 2^-1022, all as computed, the sign of l − r is right: the 16u² pays for the roundings within the
//! bound itself and 2^-1022 for both underflows. Overflow gives an infinite bound or a NaN, neither of which passes the
//! strict comparison.
//!
//! Range of step 3: if every nonzero coordinate has magnitude in [2^-400, 2^480], coordinates are multiples of 2^-452,
//! and all differences, products and their error terms are multiples of 2^-904 of magnitude at most 2^964: nothing
//! overflows, not even the 2^27-fold of a product that Dekker's splitting forms, and no rounding error is lost to
//! underflow. The smallest bound that `robust` computes, about 2^-103 times the sum of the products, is at least
//! 2^-1007 when that sum is not zero, a normal number.
//!
//! # Panics
//! In step 4 if a coordinate is not finite.
//!
//! # Checked by
//! Comparison with rational arithmetic on random, nearly collinear, denormal, huge and mixed coordinates (tests below).
//!
//! # Example
//! ```
//! use zonotope::numeric::orientation::{Turn, cross_sign, orientation};
//!
//! assert_eq!(orientation([0.0, 0.0], [2.0, 0.0], [1.0, 1.0]), Turn::Left);
//! // 0.1 + 0.2 rounds to a double one unit above 0.3
//! assert_eq!(orientation([0.0, 0.0], [1.0, 0.3], [1.0, 0.1 + 0.2]), Turn::Left);
//! // the products underflow to zero in doubles
//! assert_eq!(orientation([0.0, 0.0], [1e-200, 0.0], [0.0, 1e-200]), Turn::Left);
//! assert_eq!(cross_sign([5.0, 5.0], [6.0, 7.0], [1e300, 0.0], [1e300, 9.0]), Turn::Left);
//! ```

use std::cmp::Ordering;

use robust::{Coord, Coord3D, orient2d, orient3d};

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_product::exact_product;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::UNIT;
use crate::tally::{Operation, Tally};

mod carried_exponents;
pub(crate) mod in_space;

/// The sense of a turn in the plane, x to the right and y upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Turn {
    /// Clockwise: the cross product is negative.
    Right,
    /// Collinear or parallel: the cross product is zero.
    Straight,
    /// Counter-clockwise: the cross product is positive.
    Left,
}

impl Turn {
    /// The turn whose cross product has the sign of `value`; a NaN counts as zero.
    #[inline]
    fn from_sign_of(value: f64) -> Self {
        if value > 0.0 {
            Turn::Left
        } else if value < 0.0 {
            Turn::Right
        } else {
            Turn::Straight
        }
    }

    /// The sign of the cross product as an ordering relative to zero: `Left` is `Greater`.
    pub fn sign(self) -> Ordering {
        self.cmp(&Turn::Straight)
    }

    /// The turn after a reflection: left and right exchanged.
    pub fn reverse(self) -> Self {
        Turn::from(self.sign().reverse())
    }
}

impl From<Ordering> for Turn {
    /// The turn whose cross product compares so with zero.
    fn from(sign: Ordering) -> Self {
        match sign {
            Ordering::Less => Turn::Right,
            Ordering::Equal => Turn::Straight,
            Ordering::Greater => Turn::Left,
        }
    }
}

/// The side of the directed line `a` → `b` on which `c` lies: the sign of (b − a) × (c − a).
#[inline]
pub fn orientation(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Turn {
    cross_sign_counted(a, b, a, c, &mut ())
}

/// [`orientation`], counting one [`Operation::Turn`] and, if the filter fails, one [`Operation::ExactFallback`].
#[inline]
pub fn orientation_counted(a: [f64; 2], b: [f64; 2], c: [f64; 2], tally: &mut impl Tally) -> Turn {
    cross_sign_counted(a, b, a, c, tally)
}

/// The turn from the edge `a` → `b` to the edge `c` → `d`: the sign of (b − a) × (d − c).
#[inline]
pub fn cross_sign(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Turn {
    cross_sign_counted(a, b, c, d, &mut ())
}

/// [`cross_sign`], counting one [`Operation::Turn`] and, if the filter fails, one [`Operation::ExactFallback`].
#[inline]
pub fn cross_sign_counted(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2], tally: &mut impl Tally) -> Turn {
    tally.add(Operation::Turn, 1);
    let left = (b[0] - a[0]) * (d[1] - c[1]);
    let right = (b[1] - a[1]) * (d[0] - c[0]);
    let difference = left - right;
    if difference.abs() > FILTER_RELATIVE * (left.abs() + right.abs()) + FILTER_ABSOLUTE {
        if difference > 0.0 { Turn::Left } else { Turn::Right }
    } else {
        tally.add(Operation::ExactFallback, 1);
        exact_cross_sign(a, b, c, d)
    }
}

/// (3 + 16u)·u: relative part of the filter's error bound.
const FILTER_RELATIVE: f64 = (3.0 + 16.0 * UNIT) * UNIT;

/// Absolute part of the filter's error bound, for products that underflow.
const FILTER_ABSOLUTE: f64 = f64::MIN_POSITIVE;

/// Exponents between which expansions are exact: nonzero magnitudes in [2^LOWEST, 2^HIGHEST).
const LOWEST_EXPONENT: i32 = -400;
const HIGHEST_EXPONENT: i32 = 480;

/// Steps 2 to 4 of the method.
#[cold]
#[inline(never)]
fn exact_cross_sign(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Turn {
    if ExactEdge::new(a, b).is_equal_or_opposite_to(&ExactEdge::new(c, d)) {
        return Turn::Straight;
    }
    match exact_scale(&[a, b, c, d]) {
        Some(scale) => {
            let [a, b, c, d] = [a, b, c, d].map(|point| point.map(|value| value * scale));
            scaled_cross_sign(a, b, c, d)
        }
        None => dyadic_cross_sign(a, b, c, d),
    }
}

/// A power of two that brings every nonzero coordinate into the range of the expansions, if there is one.
fn exact_scale(points: &[[f64; 2]; 4]) -> Option<f64> {
    let mut lowest = i32::MAX;
    let mut highest = i32::MIN;
    for &value in points.as_flattened() {
        if value != 0.0 {
            lowest = lowest.min(exponent_below(value));
            highest = highest.max(exponent_below(value));
        }
    }
    if lowest > highest {
        return Some(1.0);
    }
    let shift =
        if lowest < LOWEST_EXPONENT { LOWEST_EXPONENT - lowest } else { (HIGHEST_EXPONENT - 1 - highest).min(0) };
    let fits = lowest + shift >= LOWEST_EXPONENT && highest + shift < HIGHEST_EXPONENT;
    // the shift is in [-544, 674], so its power of two is a normal number
    fits.then(|| f64::from_bits(((1023 + shift) as u64) << 52))
}

/// The largest k with 2^k ≤ |value| for a normal value; −1074, a lower bound of it, for a denormal one.
fn exponent_below(value: f64) -> i32 {
    match (value.to_bits() >> 52) & 0x7ff {
        0 => -1074,
        biased => biased as i32 - 1023,
    }
}

/// The sign for coordinates within the range of the expansions.
fn scaled_cross_sign(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Turn {
    let (first, second) = (ExactEdge::new(a, b), ExactEdge::new(c, d));
    if first.tail == [0.0; 2] && second.tail == [0.0; 2] {
        let left = exact_product(first.head[0], second.head[1]);
        let right = exact_product(first.head[1], second.head[0]);
        // rounding is monotone, so the heads decide unless they are equal
        let differ = if left.0 == right.0 { left.1 - right.1 } else { left.0 - right.0 };
        return Turn::from_sign_of(differ);
    }
    if a == c {
        let [a, b, d] = [a, b, d].map(|[x, y]| Coord { x, y });
        return Turn::from_sign_of(orient2d(a, b, d));
    }
    // With a, b at height 0 and c, d at height 1 the determinant of b − a, c − a, d − a is −(b − a) × (d − c).
    let [low_a, low_b] = [a, b].map(|[x, y]| Coord3D { x, y, z: 0.0 });
    let [high_c, high_d] = [c, d].map(|[x, y]| Coord3D { x, y, z: 1.0 });
    Turn::from_sign_of(-orient3d(low_b, high_c, high_d, low_a))
}

/// The sign by exact binary integers, for any finite coordinates.
fn dyadic_cross_sign(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Turn {
    let difference = |from: f64, to: f64| Dyadic::from_f64(to) - Dyadic::from_f64(from);
    let left = difference(a[0], b[0]) * difference(c[1], d[1]);
    let right = difference(a[1], b[1]) * difference(c[0], d[0]);
    Turn::from(left.cmp(&right))
}

/// The vector between two points as an unevaluated sum of two doubles a coordinate; NaN tails if it overflows.
struct ExactEdge {
    head: [f64; 2],
    tail: [f64; 2],
}

impl ExactEdge {
    fn new(from: [f64; 2], to: [f64; 2]) -> Self {
        let [x, y] = [0, 1].map(|axis| exact_sum(to[axis], -from[axis]));
        ExactEdge { head: [x.0, y.0], tail: [x.1, y.1] }
    }

    /// False if one of the edges overflows, since NaN equals nothing.
    fn is_equal_or_opposite_to(&self, other: &Self) -> bool {
        let opposite = |v: [f64; 2]| v.map(|value| -value);
        (self.head == other.head && self.tail == other.tail)
            || (self.head == opposite(other.head) && self.tail == opposite(other.tail))
    }
}

#[cfg(test)]
mod tests;
