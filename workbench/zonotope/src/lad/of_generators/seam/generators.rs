//! The seam: what the kernel needs of "the generators", whoever holds them.
//!
//! | implementor | what it is |
//! |---|---|
//! | [`Rows`] | rows of a body, or a sample of them |
//! | [`Query`] | one or two placed bodies, in the rows that they are stored in or, if they were prepared, in blocks |
//! | `collision::prepared::by_direction_tree` | one or two placed bodies with sums of neighbouring generators |
//! | `collision::tracking::by_warm_kernel` | two placed bodies with sums near a direction |
//!
//! Every implementor consists of at most two parts, each a slice of rows with or without a matrix. A pass is written
//! once, for a slice; where a part has a matrix, its [`Frame`] pulls the cell back before the pass and pushes the sum
//! forward after it. Transforming the generators instead would cost memory and a rounding of each of them.
//!
//! Passes of the early stage are compiled for bodies at rest and for bodies under poses ([`Generators::over`]): Σ c M v
//! is M Σ c v, and Σ w M v (M v)ᵀ is M (Σ w v vᵀ) Mᵀ. Of bodies at rest, one pass takes both runs.
//!
//! An implementor that knows more than its rows tell has its own way to sums over a cell, support values, a first cell
//! and exact sums; the rows are there all the same, for the rungs that read them one by one.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use super::direction_cone::DirectionCone;
use super::frame::Frame;
use super::sign_pass::{FixedSum, Places};
use crate::numeric::bounded::Bounded;
use crate::numeric::combined_sum::combined_sum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, ExactVector, exact};
use crate::numeric::lanes::rows::{Rows, Runs, count_of};
use crate::numeric::lanes::{bounded_sum, bounded_sum_near, signed_factors};
use crate::numeric::linear::sum_norm;
use crate::numeric::signed_sum::signed_sum;
use crate::numeric::tolerance::{DETERMINANT_OF_IMAGES, DETERMINANT_OF_ROWS};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

/// Results of a pass over the rows of one part that can become results for their images.
pub(crate) trait Carried {
    /// The result for the images of the rows, if the pass had its directions pulled back.
    fn carried(self, frame: &Frame<'_>) -> Self;

    /// The result for two parts together.
    fn joined(self, other: Self) -> Self;
}

/// Rows, and the matrix that they are to be taken under.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part<'a> {
    pub(crate) rows: Rows<'a>,
    pub(crate) frame: Option<Frame<'a>>,
}

/// Generators of space, in the order of their indices: those of the first part, then those of the second.
pub(crate) trait Generators: fmt::Debug + Sync {
    /// The generators, in two parts.
    fn parts(&self) -> [Part<'_>; 2];

    /// The number of generators.
    fn len(&self) -> usize {
        let [first, second] = self.parts();
        first.rows.len() + second.rows.len()
    }

    /// A generator in doubles, off by at most [`relative_error`](Self::relative_error) times its length.
    fn generator(&self, index: usize) -> [f64; 3] {
        of_row(&self.parts(), index, Part::image)
    }

    /// A generator, exactly.
    fn exact_generator(&self, index: usize) -> ExactVector {
        of_row(&self.parts(), index, Part::exact_image)
    }

    /// A bound on the error of a generator in doubles, in terms of its length; 0 where doubles hold the generators
    /// exactly.
    fn relative_error(&self) -> f64 {
        self.parts().iter().filter_map(|part| part.frame).map(|frame| frame.relative_error()).fold(0.0, f64::max)
    }

    /// A generator in doubles with its length |v|_1, of an image a bound of it, of which the generator is off by at
    /// most 4 u.
    #[inline(always)]
    fn vector(&self, index: usize) -> ([f64; 3], f64) {
        of_row(&self.parts(), index, Part::image_with_length)
    }

    /// Whether no implementor of the type has a matrix, so that a pass takes both runs at once.
    #[inline(always)]
    fn is_fixed() -> bool
    where
        Self: Sized,
    {
        false
    }

    /// A determinant of three generators in doubles is off by less than this part of the product of their
    /// [lengths](Self::vector).
    #[inline(always)]
    fn determinant_error() -> f64
    where
        Self: Sized,
    {
        if Self::is_fixed() { DETERMINANT_OF_ROWS } else { DETERMINANT_OF_IMAGES }
    }

    /// The period in which sums at some y read the octets of rows: they read the last octet of each period, and all
    /// octets where it is 1.
    #[inline(always)]
    fn share() -> usize
    where
        Self: Sized,
    {
        1
    }

    /// The rows of the generators.
    #[inline(always)]
    fn rows(&self) -> Runs<'_> {
        let [first, second] = self.parts();
        [first.rows, second.rows]
    }

    /// The result of a pass over all generators, which is given their rows, the range of their indices, and the
    /// directions as they are to be taken with these rows.
    #[inline(always)]
    fn over<const K: usize, T: Carried>(
        &self,
        directions: [&[f64; 3]; K],
        mut pass: impl FnMut(Runs<'_>, Range<usize>, [[f64; 3]; K]) -> T,
    ) -> T
    where
        Self: Sized,
    {
        if Self::is_fixed() {
            let runs = self.rows();
            return pass(runs, 0..count_of(runs), directions.map(|u| *u));
        }
        let [first, second] = self.parts();
        let places = first.rows.len();
        let own = first.passed(0..places, directions, &mut pass);
        if second.rows.is_empty() {
            return own;
        }
        own.joined(second.passed(places..places + second.rows.len(), directions, &mut pass))
    }

    /// Capacity hint: about n^(3/4) generators cross the cell of a sample of some √n. Memory for more
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

    /// Σ c v, to twice the digits of a double; one coefficient for each generator.
    fn combined(&self, coefficients: &[f64]) -> [BoundedDoubleDouble; 3] {
        let [first, second] = self.parts();
        let (own, others) = coefficients.split_at(first.rows.len());
        let of = |part: &Part<'_>, coefficients| part.pair_image(&combined_sum(part.rows, coefficients));
        let (own, others) = (of(&first, own), of(&second, others));
        [own[0] + others[0], own[1] + others[1], own[2] + others[2]]
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

/// The value that a function has for the part and the row of a generator, for callers that read many and ask for the
/// parts once.
#[inline(always)]
pub(crate) fn of_row<'p, 'a, T>(
    [first, second]: &'p [Part<'a>; 2],
    index: usize,
    value: impl FnOnce(&'p Part<'a>, &'a [f64; 3]) -> T,
) -> T {
    match index.checked_sub(first.rows.len()) {
        None => value(first, &first.rows.list()[index]),
        Some(index) => value(second, &second.rows.list()[index]),
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
            Some(frame) => list.extend(self.rows.list().iter().map(|v| of(&frame.image(v)))),
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
        self.frame.map_or(*v, |frame| frame.image(v))
    }

    /// The image in doubles with a bound for its length |v|_1, of which the image is off by at most 4 u.
    #[inline(always)]
    fn image_with_length(&self, v: &[f64; 3]) -> ([f64; 3], f64) {
        self.frame.map_or_else(|| (*v, sum_norm(v)), |frame| frame.image_with_length(v))
    }

    /// Writes the generators to places of their own.
    pub(crate) fn write(&self, places: &mut [[f64; 3]]) {
        places.copy_from_slice(self.rows.list());
        if let Some(frame) = self.frame {
            places.iter_mut().for_each(|v| *v = frame.image(v));
        }
    }

    /// Adds the images of some rows to a list.
    pub(crate) fn copy(&self, rows: &[[f64; 3]], list: &mut Vec<[f64; 3]>) {
        match self.frame {
            None => list.extend_from_slice(rows),
            Some(frame) => list.extend(rows.iter().map(|v| frame.image(v))),
        }
    }

    /// At least |M| x for magnitudes x.
    #[inline(always)]
    pub(crate) fn image_of_sizes(&self, x: &[f64; 3]) -> [f64; 3] {
        self.frame.map_or(*x, |frame| frame.image_of_sizes(x))
    }

    /// A pass over the rows, its result carried over to their images.
    #[inline(always)]
    fn passed<const K: usize, T: Carried>(
        &self,
        range: Range<usize>,
        directions: [&[f64; 3]; K],
        pass: &mut impl FnMut(Runs<'_>, Range<usize>, [[f64; 3]; K]) -> T,
    ) -> T {
        let runs = [self.rows, Rows::NONE];
        match self.frame {
            None => pass(runs, range, directions.map(|u| *u)),
            Some(frame) => pass(runs, range, directions.map(|u| frame.pulled(u))).carried(&frame),
        }
    }

    /// The images, if doubles hold them.
    pub(super) fn exact_images(&self) -> Option<Cow<'a, [[f64; 3]]>> {
        if self.frame.is_none() {
            return Some(self.rows.list().into());
        }
        self.rows
            .list()
            .iter()
            .map(|v| exact_linear::doubles(&self.exact_image(v)))
            .collect::<Option<Vec<_>>>()
            .map(Cow::Owned)
    }

    fn exact_image(&self, v: &[f64; 3]) -> ExactVector {
        let v = exact(*v);
        self.frame.map_or_else(|| v.clone(), |frame| frame.exact_image(&v))
    }

    /// The image of a row to twice the digits of a double.
    #[inline]
    pub(crate) fn image_in_pairs(&self, v: &[f64; 3]) -> [BoundedDoubleDouble; 3] {
        self.pair_image(&v.map(BoundedDoubleDouble::exact))
    }

    /// The image of a vector that is known to twice the digits of a double.
    pub(crate) fn pair_image(&self, v: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        self.frame.map_or(*v, |frame| frame.pair_image(v))
    }

    /// Mᵀ u to twice the digits of a double.
    pub(crate) fn pair_pulled(&self, u: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        self.frame.map_or(*u, |frame| frame.pair_pulled(u))
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
            crossing[old..].iter_mut().for_each(|v| *v = frame.image(v));
        }
        if offset > 0 {
            indices[first..].iter_mut().for_each(|index| *index += offset as u32);
        }
    }

    /// Σ |v · u| with a bound of its error. One pass.
    pub(crate) fn support(&self, u: &[f64; 3]) -> Bounded {
        match self.frame {
            None => bounded_sum(self.rows, u),
            Some(frame) => bounded_sum_near(self.rows, &frame.pulled(u), frame.pulled_size(u)),
        }
    }
}

impl Generators for Rows<'_> {
    #[inline(always)]
    fn parts(&self) -> [Part<'_>; 2] {
        [*self, Rows::NONE].map(|rows| Part { rows, frame: None })
    }

    #[inline(always)]
    fn is_fixed() -> bool {
        true
    }
}

impl<P: Standing> Generators for Query<'_, 3, P> {
    #[inline(always)]
    fn parts(&self) -> [Part<'_>; 2] {
        let [first, second] = Query::parts(self);
        [
            Part { rows: first.rows(), frame: first.standing().pose().and_then(Frame::of) },
            Part { rows: second.rows(), frame: second.standing().pose().and_then(Frame::of) },
        ]
    }

    #[inline(always)]
    fn is_fixed() -> bool {
        P::IS_FIXED
    }
}
