//! What the methods ask of a site, and the directions in which they look for the extreme one.

use std::cmp::Ordering;
use std::fmt;

use thiserror::Error;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{Ring, cross, dot};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::orientation::Turn;

/// A point of the plane, of which every question below has the exact answer.
pub trait Site: Copy + fmt::Debug {
    /// The order by abscissa, then by ordinate.
    fn order(&self, other: &Self) -> Ordering;

    /// The order by abscissa alone.
    fn abscissa_order(&self, other: &Self) -> Ordering;

    /// The order of the scalar products with a direction.
    fn order_along(&self, other: &Self, direction: Direction) -> Ordering;

    /// The side of the directed line from `a` to `b` on which `c` lies.
    fn turn(a: &Self, b: &Self, c: &Self) -> Turn;

    /// The order of two abscissas: that of the point where the line through `first` meets the line through `second`,
    /// and that of `at`. Both sites of `second` lie strictly on one side of the first line, the second one of them
    /// farther from it.
    fn crossing_order(first: [&Self; 2], second: [&Self; 2], at: &Self) -> Ordering;

    /// Exact coordinates [X, Y, W] of the point (X / W, Y / W), with W > 0.
    fn homogeneous(&self) -> [Dyadic; 3];
}

/// [`Site::crossing_order`] in exact numbers.
#[cold]
#[inline(never)]
pub(super) fn exact_crossing_order<S: Site>(first: [&S; 2], second: [&S; 2], at: &S) -> Ordering {
    let exact = |site: &S| site.homogeneous();
    match crossing_signs(first.map(exact), second.map(exact), &exact(at)).map(|sign| sign.sign()) {
        [Ordering::Less, sign] => sign.reverse(),
        [_, sign] => sign,
    }
}

/// Two numbers whose signs, multiplied, are the order of the abscissa of a crossing and the abscissa of `at`.
///
/// With d_k = det(p_1, p_2, q_k) the lines p_1 p_2 and q_1 q_2 meet in d_2 q_1 − d_1 q_2, whose third coordinate has
/// the sign of d_2 where d_1 and d_2 have one sign and d_2 is the larger.
#[inline]
pub(super) fn crossing_signs<T: Ring>(first: [[T; 3]; 2], second: [[T; 3]; 2], at: &[T; 3]) -> [T; 2] {
    let line = cross(&first[0], &first[1]);
    let beyond = |site: &[T; 3]| site[0].times(&at[2]).minus(&site[2].times(&at[0]));
    let [near, far] = [0, 1].map(|k| dot(&line, &second[k]));
    let difference = far.times(&beyond(&second[0])).minus(&near.times(&beyond(&second[1])));
    [far, difference]
}

/// A direction upward: a scalar product to be made least on a lower chain, and greatest on an upper chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction([f64; 2]);

/// Why a vector is no direction upward.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum DirectionError {
    /// A coordinate is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// The vector points down or is horizontal: what is extreme there belongs to the other chain or to its ends.
    #[error("the direction's ordinate is {ordinate}, not positive")]
    NotUpward {
        /// The second coordinate.
        ordinate: f64,
    },
}

impl Direction {
    /// The direction of a vector.
    ///
    /// # Errors
    /// [`DirectionError`] if a coordinate is not finite or the second one is not positive.
    pub fn new(vector: [f64; 2]) -> Result<Self, DirectionError> {
        NonFinite::check_vector("the direction", &vector)?;
        if vector[1] > 0.0 { Ok(Self(vector)) } else { Err(DirectionError::NotUpward { ordinate: vector[1] }) }
    }

    /// The direction (x, 1), in which the scalar product with the dual point of a line is the line's height at x.
    ///
    /// # Errors
    /// [`DirectionError::NonFinite`] if the abscissa is NaN or infinite.
    pub fn at_abscissa(x: f64) -> Result<Self, DirectionError> {
        Self::new([x, 1.0])
    }

    /// The vector.
    pub fn vector(self) -> [f64; 2] {
        self.0
    }

    /// The vector turned by a quarter counter-clockwise: a cross product with it is a scalar product with the vector.
    pub(super) fn quarter_turn(self) -> [f64; 2] {
        [-self.0[1], self.0[0]]
    }
}
