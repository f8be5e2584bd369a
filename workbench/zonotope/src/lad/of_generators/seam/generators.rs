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

use std::fmt;
use std::ops::Range;

use super::direction_cone::DirectionCone;
use super::frame::Frame;
use super::part::{Carried, Part, of_row};
use super::sign_pass::{FixedSum, Places};
use crate::numeric::bounded::Bounded;
use crate::numeric::combined_sum::combined_sum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::lanes::rows::{Rows, Runs, count_of};
use crate::numeric::signed_sum::signed_sum;
use crate::numeric::tolerance::{DETERMINANT_OF_IMAGES, DETERMINANT_OF_ROWS};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

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

    /// Whether a generator that a pass over a cell fixed has the sign of its product, as it is rounded, with every
    /// direction of doubles in the cell: the margin of a cell, eight roundings, holds three of each product. A matrix
    /// rounds more, and sums that are known beforehand read no products.
    fn has_signs_of_products(&self) -> bool {
        false
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

    /// Σ ± v with the signs of the products with a direction, in doubles. One pass.
    fn extreme_sum(&self, u: &[f64; 3]) -> [f64; 3] {
        let [first, second] = self.parts();
        let (own, others) = (first.extreme_sum(u), second.extreme_sum(u));
        [own[0] + others[0], own[1] + others[1], own[2] + others[2]]
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

    fn has_signs_of_products(&self) -> bool {
        P::IS_FIXED
    }
}
