//! The query under membership, intersection and gauge.

use super::implicit::Zonotope;
use super::prepared::{self, BodyView};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::rows::{LaidOut, Rows};
use crate::numeric::non_finite::NonFinite;

/// Where is the exact vector `to` − `from` relative to the zonotope { Σ δ_i g_i : |δ_i| ≤ 1 }? Every coordinate is
/// finite.
///
/// The generators come in two slices, so that two bodies are put to the query without a copy; a generator's index
/// counts through the first slice and then the second.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a, const D: usize> {
    from: [f64; D],
    to: [f64; D],
    generators: [&'a [[f64; D]]; 2],
    /// What was prepared of each run, in space.
    laid_out: [Option<&'a LaidOut>; 2],
}

impl<'a, const D: usize> Query<'a, D> {
    /// The displacement between two points, relative to generators. O(n).
    ///
    /// # Errors
    /// [`NonFinite`] names the first coordinate that is not finite.
    pub fn new(from: [f64; D], to: [f64; D], generators: &'a [[f64; D]]) -> Result<Self, NonFinite> {
        NonFinite::check_vector("the start", &from)?;
        NonFinite::check_vector("the end", &to)?;
        NonFinite::check_list("generator", generators)?;
        Ok(Self::of_finite(from, to, generators))
    }

    /// [`new`](Self::new) of coordinates that are known to be finite. O(1).
    pub(crate) fn of_finite(from: [f64; D], to: [f64; D], generators: &'a [[f64; D]]) -> Self {
        Self { from, to, generators: [generators, &[]], laid_out: [None; 2] }
    }

    /// Membership of a point: from the centre of the body to the point. O(1).
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is not finite.
    pub fn of_point(point: [f64; D], body: &'a Zonotope<D>) -> Result<Self, NonFinite> {
        NonFinite::check_vector("the end", &point)?;
        Ok(Self::of_finite(body.center(), point, body.generators()))
    }

    /// Intersection of two bodies (Lemma 5.1): from the centre of the first to that of the second, relative to the
    /// generators of both. O(1).
    pub fn between(a: &'a Zonotope<D>, b: &'a Zonotope<D>) -> Self {
        let generators = [a.generators(), b.generators()];
        Self { from: a.center(), to: b.center(), generators, laid_out: [None; 2] }
    }

    /// The same query, if E is the dimension in which it is asked. O(1).
    pub(crate) fn in_dimension<const E: usize>(&self) -> Option<Query<'a, E>> {
        let coordinates = |v: &[f64; D]| v.first_chunk::<E>().copied();
        let generators = self.generators.map(|run| run.as_flattened().as_chunks::<E>().0);
        let laid_out = self.laid_out;
        (D == E).then_some(Query { from: coordinates(&self.from)?, to: coordinates(&self.to)?, generators, laid_out })
    }

    /// Where the displacement starts.
    pub fn from(&self) -> [f64; D] {
        self.from
    }

    /// Where it ends.
    pub fn to(&self) -> [f64; D] {
        self.to
    }

    /// `to` − `from`, exactly: the difference of doubles is seldom a double.
    pub fn exact(&self) -> [Dyadic; D] {
        std::array::from_fn(|i| Dyadic::from_f64(self.to[i]) - Dyadic::from_f64(self.from[i]))
    }

    /// The generators, in two runs.
    pub fn runs(&self) -> [&'a [[f64; D]]; 2] {
        self.generators
    }

    /// The generators, in the order of their indices.
    pub fn generators(&self) -> impl Iterator<Item = &'a [f64; D]> {
        let [first, second] = self.generators;
        first.iter().chain(second)
    }

    /// A generator by its index.
    ///
    /// # Panics
    /// If there is no such generator.
    pub fn generator(&self, index: usize) -> [f64; D] {
        let [first, second] = self.generators;
        if index < first.len() { first[index] } else { second[index - first.len()] }
    }

    /// How many generators there are.
    pub fn len(&self) -> usize {
        self.generators[0].len() + self.generators[1].len()
    }

    /// Whether there are no generators: the zonotope is the origin.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl<'a> Query<'a, 3> {
    /// Membership of a point in a body of space, prepared or not. O(1).
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is not finite.
    pub fn of_point_in(point: [f64; 3], body: impl Into<BodyView<'a>>) -> Result<Self, NonFinite> {
        let body = body.into();
        Ok(Self { laid_out: [body.laid_out(), None], ..Self::of_point(point, body.body())? })
    }

    /// Intersection of two bodies of space, each prepared or not. O(1).
    pub fn between_bodies(a: impl Into<BodyView<'a>>, b: impl Into<BodyView<'a>>) -> Self {
        let (a, b) = (a.into(), b.into());
        Self { laid_out: [a.laid_out(), b.laid_out()], ..Self::between(a.body(), b.body()) }
    }

    /// The generators as passes take them, in two runs.
    #[inline(always)]
    pub(crate) fn rows(&self) -> [Rows<'a>; 2] {
        let ([first, second], [own, other]) = (self.generators, self.laid_out);
        [prepared::rows(first, own), prepared::rows(second, other)]
    }
}
