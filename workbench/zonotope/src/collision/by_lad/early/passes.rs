//! What the early stage asks of the generators, whoever holds them.
//!
//! A pass is written once, over two runs of rows. It takes directions and returns sums. Where the rows stand under
//! matrices, [`Passes::over`] makes the pass for each part with the directions pulled back into the frame of the rows,
//! and carries its sums forward: Σ c M v is M Σ c v, and Σ w M v (M v)ᵀ is M (Σ w v vᵀ) Mᵀ. Without a matrix it is one
//! pass over both runs, so that a query without poses pays nothing for those with poses.

use std::ops::Range;

use crate::collision::Query;
use crate::lad::of_generators::seam::generators::{Generators, KernelQuery};
use crate::lad::of_generators::seam::linear_map::LinearMap;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::lanes::rows::Rows;

/// Rows in two runs.
pub(crate) type Runs<'a> = [Rows<'a>; 2];

/// How many rows there are.
#[inline(always)]
pub(crate) fn len([first, second]: Runs<'_>) -> usize {
    first.len() + second.len()
}

/// Results of a pass over the rows of one part that can become results for their images.
pub(crate) trait Carried {
    /// The result for the images of the rows, if the pass had its directions pulled back.
    fn carried(self, map: &LinearMap<'_>) -> Self;

    /// The result for two parts together.
    fn joined(self, other: Self) -> Self;
}

/// Generators over which passes are made; those that are rows of doubles say no more than which rows.
pub(crate) trait Passes {
    /// The period in which sums at some y read the octets of rows: they read the last octet of each period, and all
    /// octets where it is 1.
    const SHARE: usize = 1;

    /// The rows of the generators.
    fn rows(&self) -> Runs<'_>;

    /// How many generators there are.
    #[inline(always)]
    fn count(&self) -> usize {
        len(self.rows())
    }

    /// The result of a pass over all generators, which is given their rows, the range of their indices, and the
    /// directions as they are to be taken with these rows.
    #[inline(always)]
    fn over<const K: usize, T: Carried>(
        &self,
        directions: [&[f64; 3]; K],
        mut pass: impl FnMut(Runs<'_>, Range<usize>, [[f64; 3]; K]) -> T,
    ) -> T {
        pass(self.rows(), 0..self.count(), directions.map(|u| *u))
    }
}

/// A query that the early stage may answer.
pub(crate) trait EarlyQuery: Passes {
    /// The displacement p in doubles, with a bound of each coordinate's error.
    fn displacement_in_doubles(&self) -> BoundedVector;

    /// A generator in doubles, with a bound of each coordinate's error.
    fn vector(&self, index: usize) -> BoundedVector;

    /// Σ |v · u| with a bound of its error. One pass.
    fn reach(&self, u: &[f64; 3]) -> Bounded;

    /// Rows picked from each run, as generators in doubles.
    fn picked(&self, capacity: usize, pick: impl Fn(&[[f64; 3]], &mut Vec<[f64; 3]>)) -> Vec<[f64; 3]>;

    /// The query as it was put, if its generators are rows of doubles.
    fn as_rows(&self) -> Option<Query<'_, 3>>;
}

/// The generators of a query of which sums read the fourth octet of each four, a quarter of all.
pub(crate) struct Quarter<'a, Q>(pub(crate) &'a Q);

impl<Q: EarlyQuery> Passes for Quarter<'_, Q> {
    const SHARE: usize = 4;

    #[inline(always)]
    fn rows(&self) -> Runs<'_> {
        self.0.rows()
    }

    #[inline(always)]
    fn over<const K: usize, T: Carried>(
        &self,
        directions: [&[f64; 3]; K],
        pass: impl FnMut(Runs<'_>, Range<usize>, [[f64; 3]; K]) -> T,
    ) -> T {
        self.0.over(directions, pass)
    }
}

impl Passes for [[f64; 3]] {
    #[inline(always)]
    fn rows(&self) -> Runs<'_> {
        [Rows::new(self), Rows::NONE]
    }
}

impl Passes for Query<'_, 3> {
    #[inline(always)]
    fn rows(&self) -> Runs<'_> {
        Query::rows(self)
    }
}

impl EarlyQuery for Query<'_, 3> {
    #[inline(always)]
    fn displacement_in_doubles(&self) -> BoundedVector {
        self.rounded_displacement()
    }

    #[inline(always)]
    fn vector(&self, index: usize) -> BoundedVector {
        bounded::exact(Query::generator(self, index))
    }

    #[inline]
    fn reach(&self, u: &[f64; 3]) -> Bounded {
        self.support(u)
    }

    #[inline]
    fn picked(&self, capacity: usize, pick: impl Fn(&[[f64; 3]], &mut Vec<[f64; 3]>)) -> Vec<[f64; 3]> {
        let mut picked = Vec::with_capacity(capacity);
        self.runs().into_iter().for_each(|run| pick(run, &mut picked));
        picked
    }

    #[inline]
    fn as_rows(&self) -> Option<Query<'_, 3>> {
        Some(*self)
    }
}
