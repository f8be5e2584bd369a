//! The generators in the plane of a facet that two of them span, and the exact sum of all others with their signs.
//!
//! Doubles tell the sign of nearly all generators, and one pass sums these up without error. The exact determinant
//! decides the few that are left. Where the pass leaves something out, as of bodies under matrices, which are off the
//! plane by roundings of their own, every generator is taken one by one.

use std::cmp::Ordering;

use crate::collision::proof::sign_rule;
use crate::collision::proof::vectors::{Vectors, cross_terms, first_of_largest};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::lanes::body_sums::sizes;
use crate::numeric::lanes::octet::LANES;
use crate::numeric::lanes::{Along, add_extreme_exactly};
use crate::numeric::linear::dot;
use crate::numeric::orientation::in_space::determinant_sign_of_rows;
use crate::numeric::reused::Reused;
use crate::numeric::tolerance::PRODUCT_UNDERFLOW;

/// A facet has seldom more generators than this.
const USUAL_MEMBERS: usize = 8;

/// Fewer generators are taken one by one: the sum of a pass takes longer to begin with.
const LEAST_COUNT: usize = 32;

/// The generators that are looked at for one that is far off the plane.
const THIRD_CANDIDATES: usize = 32;

/// The plane of two generators and the origin, and their computed normal u: a × b or, if it is reversed, its opposite.
#[derive(Clone, Copy)]
pub(super) struct Plane<'a> {
    pub(super) query: &'a dyn KernelQuery,
    pub(super) vectors: &'a Vectors<'a>,
    pub(super) pair: [usize; 2],
    pub(super) u: &'a [f64; 3],
    pub(super) is_reversed: bool,
}

/// The generators as a plane splits them.
pub(super) struct Split {
    /// Those in the plane.
    pub(super) members: Reused<usize>,
    /// Σ s v of all others.
    pub(super) sum: ExactVector,
    /// One that is far off the plane.
    pub(super) third: usize,
}

impl Plane<'_> {
    /// The generators split, and the sign of each that is not in the plane written, whatever stood in its place. `None`
    /// where all are in the plane. O(n).
    pub(super) fn split(&self, signs: &mut [f64]) -> Option<Split> {
        let are_rows = self.vectors.parts.iter().all(|part| part.frame.is_none());
        let of_pass = if are_rows && signs.len() >= LEAST_COUNT { self.split_by_pass(signs) } else { None };
        of_pass.or_else(|| self.split_one_by_one(signs))
    }

    /// The magnitudes of a generator's terms in a determinant with the two, in terms of its coordinates.
    fn terms(&self) -> [f64; 3] {
        let [a, b] = self.pair.map(|i| self.vectors.vector(i));
        cross_terms(&a, &b)
    }

    fn split_by_pass(&self, signs: &mut [f64]) -> Option<Split> {
        let runs = self.vectors.parts.each_ref().map(|part| part.rows);
        let errors = self.terms().map(|terms| self.vectors.determinant_error * terms);
        let along = Along { direction: self.u, errors: &errors, longest: sizes(runs)[0] };
        let (mut sums, mut doubtful) = (<[ExactSum; 3]>::default(), Reused::with_capacity(USUAL_MEMBERS));
        let mut add = |k: usize, offset| add_extreme_exactly(runs[k], &along, offset, &mut sums, &mut doubtful);
        if !(add(0, 0) && add(1, runs[0].len())) {
            return None;
        }
        let mut written = Reused::with_capacity(signs.len() + 2 * LANES);
        sign_rule::write(&self.vectors.parts, self.u, 1.0, &mut written);
        signs.copy_from_slice(&written);
        let mut members = Reused::with_capacity(USUAL_MEMBERS);
        for &i in &doubtful {
            let v = self.vectors.value(i);
            match self.order(i, &v) {
                Ordering::Equal => members.push(i),
                order => {
                    signs[i] = self.sign(order);
                    sums.iter_mut().zip(v).for_each(|(sum, c)| sum.add(signs[i] * c));
                }
            }
        }
        let n = self.vectors.len();
        let candidates = (0..n).step_by(n.div_ceil(THIRD_CANDIDATES)).filter(|i| !members.contains(i));
        let third = first_of_largest(candidates.map(|i| (dot(&self.vectors.value(i), self.u).abs(), i)))?;
        Some(Split { members, sum: sums.each_ref().map(ExactSum::value), third })
    }

    fn split_one_by_one(&self, signs: &mut [f64]) -> Option<Split> {
        let terms = self.terms();
        let mut members = Reused::with_capacity(USUAL_MEMBERS);
        let (mut third, mut height) = (None, 0.0);
        for (i, v) in self.vectors.iter().enumerate() {
            let along = dot(&v.value, self.u);
            if along.abs() > self.vectors.determinant_error * dot(&v.size, &terms) + PRODUCT_UNDERFLOW {
                signs[i] = along.signum();
                if along.abs() > height {
                    (third, height) = (Some(i), along.abs());
                }
                continue;
            }
            match self.order(i, &v.value) {
                Ordering::Equal => members.push(i),
                order => signs[i] = self.sign(order),
            }
        }
        let mut is_member = Reused::with_capacity(signs.len());
        is_member.resize(signs.len(), 0u32);
        members.iter().for_each(|&i| is_member[i] = 1);
        let mut off_plane = (0..signs.len()).filter(|&i| is_member[i] == 0).map(|i| (i, signs[i] as i8));
        Some(Split { sum: self.query.signed_sum_of(&mut off_plane), members, third: third? })
    }

    /// The sign of the exact determinant of the two and a generator.
    fn order(&self, index: usize, v: &[f64; 3]) -> Ordering {
        if self.vectors.parts.iter().all(|part| part.frame.is_none()) {
            let [a, b] = self.pair.map(|i| self.vectors.value(i));
            return determinant_sign_of_rows(&a, &b, v);
        }
        let [a, b] = self.pair.map(|i| self.query.exact_generator(i));
        exact_linear::dot(&exact_linear::cross(&a, &b), &self.query.exact_generator(index)).sign()
    }

    /// The sign of the product with the normal of a generator whose determinant has an order to 0.
    fn sign(&self, order: Ordering) -> f64 {
        if (order == Ordering::Greater) != self.is_reversed { 1.0 } else { -1.0 }
    }
}
