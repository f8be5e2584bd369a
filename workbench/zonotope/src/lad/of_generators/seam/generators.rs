//! The seam: what the kernel needs of "the generators", whoever holds them.
//!
//! | implementor | what it is |
//! |---|---|
//! | `[[f64; 3]]` | rows of a body, or a sample of them |
//! | [`Query`] | one or two bodies, in the rows that they are stored in or, if they were prepared, in blocks |
//! | [`Posed`] | one or two bodies under poses, whose generators are never copied |
//! | `collision::prepared::by_direction_tree` | one body, or two under poses, with sums of neighbouring generators |
//!
//! Every implementor consists of at most two parts, each a slice of rows with or without a matrix. A pass is written
//! once, for a slice; where a part has a matrix, its [`Frame`] pulls the cell back before the pass and pushes the sum
//! forward after it. Transforming the generators instead would cost memory and a rounding of each of them.
//!
//! An implementor that knows more than its rows tell has its own way to sums over a cell, support values, a first cell
//! and exact sums; the rows are there all the same, for the rungs that read them one by one.

use std::fmt;

use super::direction_cone::DirectionCone;
use super::frame::Frame;
use super::sign_pass::{FixedSum, Places};
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, ExactVector, exact};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::lanes::{bounded_sum, bounded_sum_near, signed_factors};
use crate::numeric::signed_sum::signed_sum;
use crate::tally::Tally;
use crate::zonotope::pose::Pose;
use crate::zonotope::posed_query::PosedQuery;
use crate::zonotope::query::Query;

/// Rows, and the matrix that they are to be taken under.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part<'a> {
    pub(crate) rows: Rows<'a>,
    pub(crate) frame: Option<&'a Frame>,
}

/// Generators of space, in the order of their indices: those of the first part, then those of the second.
pub(crate) trait Generators: fmt::Debug + Sync {
    /// The generators, in two parts.
    fn parts(&self) -> [Part<'_>; 2];

    /// How many generators there are.
    fn len(&self) -> usize {
        let [first, second] = self.parts();
        first.rows.len() + second.rows.len()
    }

    /// A generator in doubles, off by at most [`relative_error`](Self::relative_error) times its length.
    fn generator(&self, index: usize) -> [f64; 3] {
        generator_of(&self.parts(), index)
    }

    /// A generator, exactly.
    fn exact_generator(&self, index: usize) -> ExactVector {
        let [first, second] = self.parts();
        match index.checked_sub(first.rows.len()) {
            None => first.exact_image(&first.rows.list()[index]),
            Some(index) => second.exact_image(&second.rows.list()[index]),
        }
    }

    /// How far a generator in doubles is off, in terms of its length; 0 where doubles hold the generators exactly.
    fn relative_error(&self) -> f64 {
        self.parts().iter().filter_map(|part| part.frame).map(Frame::relative_error).fold(0.0, f64::max)
    }

    /// How many generators are likely to cross the cell of a sample of some √n: about n^(3/4) of them. Memory for more
    /// than that is taken when they come.
    fn expected_crossing(&self) -> usize {
        let root = self.len().isqrt();
        64 + 13 * root * root.isqrt() / 8
    }

    /// Σ |v · u| with a bound of its error. One pass.
    fn support(&self, u: &[f64; 3]) -> Bounded {
        let [first, second] = self.parts();
        if second.rows.is_empty() { first.support(u) } else { first.support(u) + second.support(u) }
    }

    /// The sum of the generators whose sign is fixed in a cell, with these signs, by one pass; the other generators
    /// are added to a list, and their indices to a second one.
    fn split(&self, cell: &DirectionCone, crossing: &mut Vec<[f64; 3]>, indices: &mut Places) -> FixedSum {
        let mut fixed = FixedSum::default();
        let mut offset = 0;
        for part in self.parts() {
            if !part.rows.is_empty() {
                fixed = fixed.plus(&part.split(cell, offset, crossing, indices));
            }
            offset += part.rows.len();
        }
        fixed
    }

    /// Σ sign · v, exactly; one sign for each generator.
    fn signed_sum(&self, signs: &[i8]) -> ExactVector {
        let [first, second] = self.parts();
        let (own, others) = signs.split_at(first.rows.len());
        let of = |part: &Part<'_>, signs: &[i8]| {
            let sum = signed_sum(part.rows.list().iter().copied().zip(signs.iter().copied()));
            part.frame.map_or_else(|| sum.clone(), |frame| frame.exact_image(&sum))
        };
        if second.rows.is_empty() { of(&first, own) } else { exact_linear::sum(&of(&first, own), &of(&second, others)) }
    }

    /// Σ sign · v over some generators alone, exactly; `terms` gives the index and the sign of each.
    fn signed_sum_of(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> ExactVector {
        if self.parts().iter().all(|part| part.frame.is_none()) {
            return signed_sum(terms.map(|(index, sign)| (self.generator(index), sign)));
        }
        let mut signs = vec![0; self.len()];
        terms.for_each(|(index, sign)| signs[index] = sign);
        self.signed_sum(&signs)
    }
}

/// Generators and the displacement that is asked about.
pub(crate) trait KernelQuery: Generators {
    /// The displacement p, exactly.
    fn exact(&self) -> ExactVector;

    /// The displacement p in doubles, with a bound of each coordinate's error.
    fn rounded_displacement(&self) -> BoundedVector;

    /// The query as it was put, if doubles hold its generators exactly.
    fn as_query(&self) -> Option<Query<'_, 3>>;

    /// A cell that is likely to hold the optimum, where whoever holds the generators knows more of them than a sample
    /// tells; its centre is a direction u with u · p = 1.
    fn likely_cell(&self, _: &mut dyn Tally) -> Option<DirectionCone> {
        None
    }

    /// Σ sign · v with the signs of the products with a direction, exactly, where it is known without reading all
    /// generators; 0 is the sign of those that are orthogonal to it.
    fn exact_sum_along(&self, _: &ExactVector) -> Option<ExactVector> {
        None
    }

    /// s such that the gauge of any x is at most s |x|_1, if that is known beforehand.
    fn known_gauge_bound(&self) -> Option<f64> {
        None
    }
}

impl dyn KernelQuery + '_ {
    /// All generators in doubles, in the order of their indices.
    pub(crate) fn generators(&self) -> impl Iterator<Item = [f64; 3]> {
        self.parts().into_iter().flat_map(|part| part.images())
    }
}

/// A generator in doubles, for callers that read many and ask for the parts once.
#[inline]
pub(crate) fn generator_of([first, second]: &[Part<'_>; 2], index: usize) -> [f64; 3] {
    match index.checked_sub(first.rows.len()) {
        None => first.image(&first.rows.list()[index]),
        Some(index) => second.image(&second.rows.list()[index]),
    }
}

impl<'a> Part<'a> {
    /// The generators in doubles.
    #[inline]
    pub(crate) fn images(self) -> impl Iterator<Item = [f64; 3]> + 'a {
        self.rows.list().iter().map(move |v| self.image(v))
    }

    /// Adds a number for each generator in doubles to the end of a list.
    #[inline]
    pub(crate) fn map_into<T>(&self, list: &mut impl Extend<T>, of: impl Fn(&[f64; 3]) -> T) {
        match self.frame {
            None => list.extend(self.rows.list().iter().map(of)),
            Some(frame) => list.extend(self.rows.list().iter().map(|v| of(&frame.map().image(v)))),
        }
    }

    /// Adds a factor for each generator to the end of a list, with the sign of its product with the centre of a cell.
    pub(crate) fn signed_factors(&self, cell: &DirectionCone, factor: f64, list: &mut Vec<f64>) {
        match self.frame {
            None => signed_factors(self.rows, &cell.center, factor, list),
            Some(_) => self.map_into(list, |v| factor.copysign(cell.value(v))),
        }
    }

    #[inline]
    pub(crate) fn image(&self, v: &[f64; 3]) -> [f64; 3] {
        self.frame.map_or(*v, |frame| frame.map().image(v))
    }

    fn exact_image(&self, v: &[f64; 3]) -> ExactVector {
        let v = exact(*v);
        self.frame.map_or_else(|| v.clone(), |frame| frame.exact_image(&v))
    }

    /// The image of a vector that is known to twice the digits of a double.
    pub(crate) fn pair_image(&self, v: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        self.frame.map_or(*v, |frame| frame.pair_image(v))
    }

    /// Mᵀ u, exactly: its products with the rows are those of u with the images of the rows.
    pub(crate) fn exact_pulled(&self, u: &ExactVector) -> ExactVector {
        self.frame.map_or_else(|| u.clone(), |frame| frame.exact_pulled(u))
    }

    /// The sum of the generators whose sign is fixed in a cell; the others are added to a list, and their places, from
    /// an offset on, to a second one. One pass.
    pub(crate) fn split(
        &self,
        cell: &DirectionCone,
        offset: usize,
        crossing: &mut Vec<[f64; 3]>,
        indices: &mut Places,
    ) -> FixedSum {
        let first = indices.len();
        let fixed = match self.frame {
            None => cell.split(self.rows, indices),
            Some(frame) => frame.pushed_sum(&frame.pulled_cell(cell).split(self.rows, indices)),
        };
        self.gather(first, offset, crossing, indices);
        fixed
    }

    /// Adds the generators whose places are the last ones of a list to another list, and moves these places by an
    /// offset.
    pub(crate) fn gather(&self, first: usize, offset: usize, crossing: &mut Vec<[f64; 3]>, indices: &mut Places) {
        let old = crossing.len();
        self.rows.copy_some(&indices[first..], crossing);
        if let Some(frame) = self.frame {
            crossing[old..].iter_mut().for_each(|v| *v = frame.map().image(v));
        }
        if offset > 0 {
            indices[first..].iter_mut().for_each(|index| *index += offset as u32);
        }
    }

    /// Σ |v · u| with a bound of its error. One pass.
    pub(crate) fn support(&self, u: &[f64; 3]) -> Bounded {
        match self.frame {
            None => bounded_sum(self.rows, u),
            Some(frame) => {
                let map = frame.map();
                bounded_sum_near(self.rows, &map.pulled(u), map.pulled_size(u))
            }
        }
    }
}

impl Generators for [[f64; 3]] {
    fn parts(&self) -> [Part<'_>; 2] {
        [Rows::new(self), Rows::NONE].map(|rows| Part { rows, frame: None })
    }
}

impl Generators for Query<'_, 3> {
    fn parts(&self) -> [Part<'_>; 2] {
        self.rows().map(|rows| Part { rows, frame: None })
    }
}

impl KernelQuery for Query<'_, 3> {
    fn exact(&self) -> ExactVector {
        Query::exact(self)
    }

    fn rounded_displacement(&self) -> BoundedVector {
        bounded::difference(self.from(), self.to())
    }

    fn as_query(&self) -> Option<Query<'_, 3>> {
        Some(*self)
    }
}

/// A query about posed bodies with the bounds that passes under its matrices need.
#[derive(Debug)]
pub(crate) struct Posed<'a> {
    query: &'a PosedQuery<'a>,
    /// The displacement, rounded.
    p: BoundedVector,
    /// The matrix of each run; none for the identity.
    frames: [Option<Frame>; 2],
}

impl<'a> Posed<'a> {
    pub(crate) fn new(query: &'a PosedQuery<'a>) -> Self {
        let frame = |pose: Pose| Some(Frame::new(&pose)).filter(|frame| !frame.is_identity());
        Self { query, p: query.rounded_displacement(), frames: query.poses().map(frame) }
    }
}

impl Generators for Posed<'_> {
    fn parts(&self) -> [Part<'_>; 2] {
        let [first, second] = self.frames.each_ref().map(Option::as_ref);
        let [rows, others] = self.query.rows();
        [Part { rows, frame: first }, Part { rows: others, frame: second }]
    }
}

impl KernelQuery for Posed<'_> {
    fn exact(&self) -> ExactVector {
        self.query.displacement().clone()
    }

    fn rounded_displacement(&self) -> BoundedVector {
        self.p
    }

    fn as_query(&self) -> Option<Query<'_, 3>> {
        None
    }
}
