//! Lines that are not vertical: the line y = m x + q is the point (m, q).
//!
//! The height of a line at x is the scalar product of its point with (x, 1): the lower envelope of lines is the lower
//! chain of their points, the upper envelope the upper chain. For a line a x + b y + c = 0 the point is (−a / b, −c /
//! b) and no pair of doubles; it is kept as [X, Y, W], and every question is the sign of a determinant of such rows.

use std::cmp::Ordering;

use thiserror::Error;

use super::site::{Direction, Site, crossing_signs, exact_crossing_order};
use crate::numeric::bounded::exact;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::orientation::in_space::{Direction as Vector, determinant_sign};
use crate::numeric::orientation::{Turn, cross_sign};

/// A line a x + b y + c = 0 with b ≠ 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlopedLine {
    /// The coordinates [X, Y, W] of the dual point (X / W, Y / W), W > 0: its slope and its height at x = 0.
    dual: Vector,
}

/// Why a row is no line with a slope.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SlopedLineError {
    /// A coefficient is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// The coefficient of y is zero: the line is vertical, or no line at all.
    #[error("the coefficient of y is zero: the line has no slope")]
    Vertical,
}

impl SlopedLine {
    /// The line a x + b y + c = 0 of a row [a, b, c]. The dual line of a generator has the generator's coordinates.
    ///
    /// # Errors
    /// [`SlopedLineError`] if a coefficient is not finite or b = 0.
    pub fn new(row: [f64; 3]) -> Result<Self, SlopedLineError> {
        NonFinite::check_vector("the line", &row)?;
        let [a, b, c] = row;
        if b == 0.0 {
            return Err(SlopedLineError::Vertical);
        }
        Ok(Self { dual: Vector::new(if b > 0.0 { [-a, -c, b] } else { [a, c, -b] }) })
    }

    /// The sign of the cross product of two planar parts of the rows.
    #[inline]
    fn order_of_quotients(&self, other: &Self, axis: usize) -> Ordering {
        let part = |line: &Self| [line.dual.original()[axis], line.dual.original()[2]];
        cross_sign([0.0; 2], part(self), [0.0; 2], part(other)).sign()
    }
}

impl Site for SlopedLine {
    #[inline]
    fn order(&self, other: &Self) -> Ordering {
        self.abscissa_order(other).then_with(|| self.order_of_quotients(other, 1))
    }

    #[inline]
    fn abscissa_order(&self, other: &Self) -> Ordering {
        self.order_of_quotients(other, 0)
    }

    #[inline]
    fn order_along(&self, other: &Self, direction: Direction) -> Ordering {
        let [x, y] = direction.quarter_turn();
        determinant_sign(&other.dual, &self.dual, &Vector::new([x, y, 0.0]))
    }

    #[inline]
    fn turn(a: &Self, b: &Self, c: &Self) -> Turn {
        Turn::from(determinant_sign(&a.dual, &b.dual, &c.dual))
    }

    #[inline]
    fn crossing_order(first: [&Self; 2], second: [&Self; 2], at: &Self) -> Ordering {
        let bounded = |line: &Self| exact(line.dual.original());
        match crossing_signs(first.map(bounded), second.map(bounded), &bounded(at)).map(|sign| sign.sign()) {
            [Some(side), Some(sign)] => (side * sign).cmp(&0),
            _ => exact_crossing_order(first, second, at),
        }
    }

    fn homogeneous(&self) -> [Dyadic; 3] {
        exact_linear::exact(self.dual.original())
    }
}
