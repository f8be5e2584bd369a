//! A vertex of the arrangement: exact in homogeneous coordinates, and as doubles with a bound on their errors.
//!
//! The exact coordinates are polynomials in those of the two lines, so they need no division and stay short; rationals
//! would be reduced at every operation.

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::arrangement::ExactLine;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// The common point of two lines that are not parallel.
#[derive(Debug, Clone)]
pub(crate) struct Vertex {
    /// Homogeneous coordinates [X, Y, W] with W > 0.
    pub(crate) exact: [Dyadic; 3],
    /// The point rounded to doubles, which are not finite where it leaves their range.
    pub(crate) point: [f64; 2],
    /// A bound on the error of each rounded coordinate.
    pub(crate) error: [f64; 2],
    /// Lines of the instance that are known to pass through the point.
    on: [Option<u32>; 2],
    is_double: OnceCell<bool>,
}

impl Vertex {
    /// The common point of two lines, which are the lines `on` of the instance where they are lines of it at all.
    pub(crate) fn new(first: &ExactLine, second: &ExactLine, on: [Option<u32>; 2]) -> Self {
        Self { on, ..Self::at(first.meet(second)) }
    }

    /// The point with the given homogeneous coordinates.
    pub(crate) fn at(exact: [Dyadic; 3]) -> Self {
        debug_assert!(exact[2].sign() == Ordering::Greater, "a point has a positive last coordinate");
        let point = [exact[0].ratio(&exact[2]), exact[1].ratio(&exact[2])];
        let error = point.map(|v| 8.0 * UNIT * v.abs() + UNDERFLOW);
        Self { exact, point, error, on: [None; 2], is_double: OnceCell::new() }
    }

    /// The point, if its coordinates are doubles.
    pub(crate) fn as_doubles(&self) -> Option<[f64; 2]> {
        let [x, y, w] = &self.exact;
        let is_double = |exact: &Dyadic, value: f64| value.is_finite() && *exact == w * &Dyadic::from_f64(value);
        let holds = || is_double(x, self.point[0]) && is_double(y, self.point[1]);
        self.is_double.get_or_init(holds).then_some(self.point)
    }

    pub(crate) fn is_on(&self, line: u32) -> bool {
        self.on.contains(&Some(line))
    }

    /// The side of a line on which the point lies: 1, −1, or 0 when it is on the line.
    pub(crate) fn exact_side(&self, line: &ExactLine) -> i8 {
        line.evaluate(&self.exact).sign() as i8
    }
}
