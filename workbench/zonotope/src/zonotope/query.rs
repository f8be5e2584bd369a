//! The query under membership, intersection and gauge.

use std::array;

use super::implicit::Zonotope;
use super::placed::{AtRest, Placed, Standing};
use super::pose::Pose;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::max_norm;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::tolerance::{DISPLACEMENT_ACCURACY, PRODUCT_UNDERFLOW, UNIT};

/// Where is the exact vector from the centre of one placed body to that of another relative to the zonotope { Σ δ_i g_i
/// : |δ_i| ≤ 1 } of the generators of both, each under the matrix of its body's pose? Every coordinate is finite.
///
/// Two bodies are put to the query without a copy; a generator's index counts through the first body and then the
/// second.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a, const D: usize, P = AtRest> {
    parts: [Placed<'a, D, P>; 2],
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
        Self { parts: [Placed::of_finite(from, generators), Placed::point(to)] }
    }

    /// Membership of a point: from the centre of the body to the point. O(1).
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is not finite.
    pub fn of_point(point: [f64; D], body: &'a Zonotope<D>) -> Result<Self, NonFinite> {
        Self::of_point_in(point, Placed::from(body))
    }

    /// Intersection of two bodies (Lemma 5.1): from the centre of the first to that of the second, relative to the
    /// generators of both. O(1).
    pub fn between(a: &'a Zonotope<D>, b: &'a Zonotope<D>) -> Self {
        Self::of_placed(Placed::from(a), Placed::from(b))
    }

    /// Where the displacement starts.
    pub fn from(&self) -> [f64; D] {
        self.parts[0].center()
    }

    /// Where it ends.
    pub fn to(&self) -> [f64; D] {
        self.parts[1].center()
    }

    /// The generators, in the order of their indices.
    pub fn generators(&self) -> impl Iterator<Item = &'a [f64; D]> {
        let [first, second] = self.runs();
        first.iter().chain(second)
    }

    /// A generator by its index.
    ///
    /// # Panics
    /// If there is no such generator.
    pub fn generator(&self, index: usize) -> [f64; D] {
        *self.located(index).1
    }
}

impl<'a, const D: usize, P: Standing> Query<'a, D, P> {
    /// Membership of a point in a placed body. O(1).
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is not finite.
    pub fn of_point_in(point: [f64; D], body: Placed<'a, D, P>) -> Result<Self, NonFinite> {
        NonFinite::check_vector("the end", &point)?;
        Ok(Self::of_placed(body, Placed::point(point)))
    }

    /// Intersection of two placed bodies. O(1).
    pub fn of_placed(first: Placed<'a, D, P>, second: Placed<'a, D, P>) -> Self {
        Self { parts: [first, second] }
    }

    /// The bodies, the second one a point where membership is asked for.
    pub fn parts(&self) -> &[Placed<'a, D, P>; 2] {
        &self.parts
    }

    /// The body of a generator, and the generator as it is stored there.
    pub(crate) fn located(&self, index: usize) -> (&Placed<'a, D, P>, &'a [f64; D]) {
        let [first, second] = &self.parts;
        match index.checked_sub(first.generators().len()) {
            None => (first, &first.generators()[index]),
            Some(index) => (second, &second.generators()[index]),
        }
    }

    /// The same query, if E is the dimension in which it is asked. O(1).
    pub(crate) fn in_dimension<const E: usize>(&self) -> Option<Query<'a, E, P>> {
        let [first, second] = &self.parts;
        Some(Query { parts: [first.in_dimension()?, second.in_dimension()?] })
    }

    /// The same query, if its bodies stand as they are stored. O(1).
    pub(crate) fn at_rest(&self) -> Option<Query<'a, D>> {
        let [first, second] = &self.parts;
        Some(Query { parts: [first.at_rest()?, second.at_rest()?] })
    }

    /// The displacement, exactly: the difference of doubles is seldom a double, nor is the image of a centre.
    pub fn exact(&self) -> [Dyadic; D] {
        let [from, to] = self.ends();
        array::from_fn(|i| &to[i] - &from[i])
    }

    /// The generators where they stand, exactly, in the order of their indices.
    pub(crate) fn exact_generators(&self) -> impl Iterator<Item = [Dyadic; D]> {
        let of = |body: &'_ Placed<'a, D, P>| {
            let body = *body;
            body.generators().iter().map(move |v| body.exact_image(v.map(Dyadic::from_f64)))
        };
        let [first, second] = &self.parts;
        of(first).chain(of(second))
    }

    /// Where the displacement starts and ends, exactly.
    pub(crate) fn ends(&self) -> [[Dyadic; D]; 2] {
        self.parts.each_ref().map(Placed::exact_center)
    }

    /// The displacement to twice the digits of a double.
    #[inline]
    pub(crate) fn displacement_pairs(&self) -> [BoundedDoubleDouble; D] {
        let [from, to] = self.parts.each_ref().map(Placed::center_in_pairs);
        array::from_fn(|k| to[k] - from[k])
    }

    /// The generators as they are stored, in two runs.
    pub fn runs(&self) -> [&'a [[f64; D]]; 2] {
        [self.parts[0].generators(), self.parts[1].generators()]
    }

    /// How many generators there are.
    pub fn len(&self) -> usize {
        let [first, second] = self.runs();
        first.len() + second.len()
    }

    /// Whether there are no generators: the zonotope is the origin.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl<'a, P: Standing> Query<'a, 3, P> {
    /// The generators as passes take them, in two runs.
    #[inline(always)]
    pub(crate) fn rows(&self) -> [Rows<'a>; 2] {
        [self.parts[0].rows(), self.parts[1].rows()]
    }

    /// Whether no entry of a pose's matrix is too large, and not all are too small, for products in doubles.
    #[inline(always)]
    pub(crate) fn is_moderate(&self) -> bool {
        let of = |body: &Placed<'_, 3, P>| body.standing().pose().is_none_or(Pose::is_moderate);
        P::IS_FIXED || of(&self.parts[0]) && of(&self.parts[1])
    }

    /// The displacement in doubles, by plain sums, with a bound of each coordinate's error: that of the terms, which
    /// may be far larger than their sum.
    #[inline]
    pub(crate) fn displacement_estimate(&self) -> BoundedVector {
        let [first, second] = &self.parts;
        let (Some(from), Some(to)) = (first.standing().pose(), second.standing().pose()) else {
            return bounded::difference(first.center(), second.center());
        };
        let ([a, b, c], [d, e, f]) = (from.rounded_point(&first.center()), to.rounded_point(&second.center()));
        // a coordinate goes through five roundings
        let difference = |(from, size): (f64, f64), (to, other): (f64, f64)| Bounded {
            value: to - from,
            error: 8.0 * UNIT * (size + other) + PRODUCT_UNDERFLOW,
        };
        [difference(a, d), difference(b, e), difference(c, f)]
    }

    /// The displacement in doubles, with a bound of each coordinate's error that is small beside the largest
    /// coordinate.
    #[inline]
    pub(crate) fn rounded_displacement(&self) -> BoundedVector {
        if P::IS_FIXED {
            return self.displacement_estimate();
        }
        let p = self.displacement_pairs().map(|pair| pair.rounded());
        let limit = DISPLACEMENT_ACCURACY * max_norm(&p.map(|c| c.value));
        // false for NaN as well
        let is_known = p.iter().all(|c| c.error < limit);
        if is_known { p } else { self.exact().each_ref().map(rounded) }
    }
}

/// An exact number in doubles.
fn rounded(exact: &Dyadic) -> Bounded {
    let value = exact.to_f64();
    let is_exact = value.is_finite() && Dyadic::from_f64(value) == *exact;
    Bounded { value, error: if is_exact { 0.0 } else { 4.0 * f64::EPSILON * value.abs() + f64::from_bits(1) } }
}
