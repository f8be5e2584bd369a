//! A vertex of the arrangement: as doubles with a bound on their errors, by pairs of doubles, and exactly in
//! homogeneous coordinates.
//!
//! The exact coordinates are polynomials in those of the two lines, so they need no division and stay short; rationals
//! would be reduced at every operation. They are made when a decision needs them, which is seldom where the source of
//! the lines knows their common points by pairs of doubles.

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::arrangement::ExactLine;
use crate::lad::of_lines::input::LadProblem;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// The common point of two lines that are not parallel.
#[derive(Debug, Clone)]
pub(crate) struct Vertex {
    /// Homogeneous coordinates [X, Y, W] with W > 0, once they were needed.
    exact: OnceCell<[Dyadic; 3]>,
    source: Source,
    /// The point rounded to doubles, which are not finite where it leaves their range.
    pub(crate) point: [f64; 2],
    /// A bound on the error of each rounded coordinate: 8 UNIT of it, and [`UNDERFLOW`].
    pub(crate) error: [f64; 2],
    /// The point by pairs of doubles, where it was made of them.
    pub(crate) place: Option<[BoundedDoubleDouble; 2]>,
    /// Lines of the instance that are known to pass through the point.
    on: [Option<u32>; 2],
    is_double: OnceCell<bool>,
}

/// That of which the exact coordinates are made.
#[derive(Debug, Clone, Copy)]
enum Source {
    /// They were given.
    Given,
    /// The positions of two lines in the problem.
    Lines([usize; 2]),
    /// The pairs of doubles, which are exact.
    Pairs,
}

impl Vertex {
    /// The common point of two lines, which are the lines `on` of the instance where they are lines of it at all.
    pub(super) fn meeting(first: &ExactLine, second: &ExactLine, on: [Option<u32>; 2]) -> Self {
        Self { on, ..Self::at(first.meet(second)) }
    }

    /// The same by pairs of doubles, given the positions of both lines in the problem.
    pub(super) fn meeting_near(place: [BoundedDoubleDouble; 2], positions: [usize; 2], on: [u32; 2]) -> Self {
        Self { on: on.map(Some), ..Self::near(place, Source::Lines(positions)) }
    }

    /// The point with the given homogeneous coordinates.
    pub(crate) fn at(exact: [Dyadic; 3]) -> Self {
        assert!(exact[2].sign() == Ordering::Greater, "a point has a positive last coordinate");
        let point = [exact[0].ratio(&exact[2]), exact[1].ratio(&exact[2])];
        Self { exact: OnceCell::from(exact), place: None, ..Self::of(point, Source::Given) }
    }

    /// The point of pairs of doubles that are exact.
    pub(crate) fn at_pairs(place: [BoundedDoubleDouble; 2]) -> Self {
        assert!(place.iter().all(|coordinate| coordinate.parts().1 == 0.0), "the pairs are exact");
        Self::near(place, Source::Pairs)
    }

    fn near(place: [BoundedDoubleDouble; 2], source: Source) -> Self {
        Self { place: Some(place), ..Self::of(place.map(|coordinate| coordinate.high), source) }
    }

    fn of(point: [f64; 2], source: Source) -> Self {
        let error = point.map(|v| 8.0 * UNIT * v.abs() + UNDERFLOW);
        Self { exact: OnceCell::new(), source, point, error, place: None, on: [None; 2], is_double: OnceCell::new() }
    }

    /// The point in homogeneous coordinates [X, Y, W] with W > 0, in the problem for which it was made.
    pub(crate) fn exact(&self, problem: &LadProblem) -> &[Dyadic; 3] {
        self.exact.get_or_init(|| match (self.source, self.place) {
            (Source::Lines([first, second]), _) => problem.exact.line(first).meet(&problem.exact.line(second)),
            (Source::Pairs, Some(place)) => {
                let [x, y] = place.map(BoundedDoubleDouble::to_dyadic);
                [x, y, Dyadic::one()]
            }
            (Source::Given | Source::Pairs, _) => unreachable!("what is given is there from the start"),
        })
    }

    /// The point, if its coordinates are doubles.
    pub(crate) fn as_doubles(&self, problem: &LadProblem) -> Option<[f64; 2]> {
        if self.place.is_some_and(|place| place.iter().any(BoundedDoubleDouble::is_no_double)) {
            return None;
        }
        let is_double =
            |exact: &Dyadic, w: &Dyadic, value: f64| value.is_finite() && *exact == w * &Dyadic::from_f64(value);
        let holds = || {
            let [x, y, w] = self.exact(problem);
            is_double(x, w, self.point[0]) && is_double(y, w, self.point[1])
        };
        self.is_double.get_or_init(holds).then_some(self.point)
    }

    /// The same point, of which it is not known on which lines of another instance it lies.
    pub(crate) fn unnamed(self) -> Self {
        Self { on: [None; 2], ..self }
    }

    pub(crate) fn is_on(&self, line: u32) -> bool {
        self.on.contains(&Some(line))
    }

    /// The side of a line on which the point lies: 1, −1, or 0 when it is on the line.
    pub(crate) fn exact_side(&self, problem: &LadProblem, line: &ExactLine) -> i8 {
        line.evaluate(self.exact(problem)).sign() as i8
    }
}
