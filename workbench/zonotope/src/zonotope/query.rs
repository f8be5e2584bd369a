//! The query under membership, intersection and gauge, and the placed bodies that it is about.

use std::array;

use super::implicit::Zonotope;
use super::pose::{AtRest, Pose, Standing};
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::rows::{LaidOut, Rows};
use crate::numeric::linear::max_norm;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::tolerance::{DISPLACEMENT_ACCURACY, PRODUCT_UNDERFLOW, UNIT};

/// A body that questions are asked about, prepared or not, where it stands: references to its parts, nothing copied.
///
/// [`Zonotope::at`] and [`PreparedBody::at`](super::PreparedBody::at) make one under a pose. Wherever one is expected,
/// `&body` is the body as it stands: bodies with and without a pose are asked about each other.
#[derive(Debug, Clone, Copy)]
pub struct Placed<'a, const D: usize = 3, P = AtRest> {
    center: [f64; D],
    generators: &'a [[f64; D]],
    /// The generators as they were prepared, in space.
    laid_out: Option<&'a LaidOut>,
    standing: P,
}

impl<'a, const D: usize> Placed<'a, D> {
    /// A body of a centre and generators that are known to be finite, as it is stored.
    #[inline]
    pub(crate) fn of_finite(center: [f64; D], generators: &'a [[f64; D]]) -> Self {
        Self { center, generators, laid_out: None, standing: AtRest }
    }
}

impl<'a> Placed<'a> {
    /// The body where a pose puts it. O(1).
    #[inline]
    pub fn at(self, pose: &Pose) -> Placed<'a, 3, Pose> {
        self.standing_as(*pose)
    }

    /// The body with what was prepared of its generators.
    #[inline]
    pub(crate) fn with_blocks(self, laid_out: &'a LaidOut) -> Self {
        Self { laid_out: Some(laid_out), ..self }
    }

    /// The body in a standing of either kind.
    #[inline]
    pub(crate) fn standing_as<P: Standing>(self, standing: P) -> Placed<'a, 3, P> {
        let Self { center, generators, laid_out, .. } = self;
        Placed { center, generators, laid_out, standing }
    }
}

impl<'a, const D: usize, P: Standing> Placed<'a, D, P> {
    /// A point, which no pose moves.
    #[inline]
    pub(crate) fn point(center: [f64; D]) -> Self {
        Self { center, generators: &[], laid_out: None, standing: P::default() }
    }

    /// The centre of the body as it is stored.
    #[inline]
    pub fn center(&self) -> [f64; D] {
        self.center
    }

    /// The generators as they are stored.
    #[inline]
    pub fn generators(&self) -> &'a [[f64; D]] {
        self.generators
    }

    /// The place of the body.
    #[inline]
    pub fn standing(&self) -> &P {
        &self.standing
    }

    /// The same body, if E is its dimension. O(1).
    #[inline]
    pub(crate) fn in_dimension<const E: usize>(&self) -> Option<Placed<'a, E, P>> {
        let Self { laid_out, standing, .. } = *self;
        let generators = self.generators.as_flattened().as_chunks::<E>().0;
        (D == E).then_some(Placed { center: *self.center.first_chunk()?, generators, laid_out, standing })
    }

    /// The same body, if it stands as it is stored. O(1).
    #[inline]
    pub(crate) fn at_rest(&self) -> Option<Placed<'a, D>> {
        let Self { center, generators, laid_out, .. } = *self;
        P::IS_FIXED.then_some(Placed { center, generators, laid_out, standing: AtRest })
    }

    /// The centre where it stands, exactly.
    pub(crate) fn exact_center(&self) -> [Dyadic; D] {
        match self.standing.pose().zip(self.center.first_chunk::<3>()) {
            None => self.center.map(Dyadic::from_f64),
            Some((pose, center)) => in_space(pose.exact_point(*center)),
        }
    }

    /// The centre where it stands, to twice the digits of a double.
    #[inline]
    pub(crate) fn center_in_pairs(&self) -> [BoundedDoubleDouble; D] {
        let of = BoundedDoubleDouble::exact;
        let center = self.center.map(of);
        let Some(pose) = self.standing.pose() else { return center };
        let (image, translation) = (pose.pair_image(&in_space(center)), pose.translation());
        in_space([0, 1, 2].map(|k| image[k] + of(translation[k])))
    }

    /// The image of a vector under the matrix of the pose, to twice the digits of a double.
    #[inline]
    pub(crate) fn pair_image(&self, v: [BoundedDoubleDouble; D]) -> [BoundedDoubleDouble; D] {
        match self.standing.pose() {
            None => v,
            Some(pose) => in_space(pose.pair_image(&in_space(v))),
        }
    }

    /// The image of a vector under the matrix of the pose, exactly.
    pub(crate) fn exact_image(&self, v: [Dyadic; D]) -> [Dyadic; D] {
        match self.standing.pose() {
            None => v,
            Some(pose) => in_space(pose.exact_image(&in_space(v))),
        }
    }
}

impl<'a, P: Standing> Placed<'a, 3, P> {
    /// The body with its centre where it stands at a place of finite coordinates.
    pub(crate) fn centered_at(self, place: [f64; 3]) -> Self {
        let center = if P::IS_FIXED { place } else { [0.0; 3] };
        Self { center, standing: self.standing.with_translation(place), ..self }
    }

    /// The generators as passes take them.
    #[inline(always)]
    pub(crate) fn rows(&self) -> Rows<'a> {
        self.laid_out.map_or(Rows::new(self.generators), |laid_out| Rows::laid_out(self.generators, laid_out))
    }
}

/// A vector of space, to which alone poses apply.
pub(crate) fn in_space<T, const D: usize, const E: usize>(v: [T; D]) -> [T; E] {
    let mut coordinates = v.into_iter();
    array::from_fn(|_| coordinates.next().expect("bodies under poses are bodies of space"))
}

/// A vector as one of space, the coordinates beyond D 0.
#[inline]
pub(crate) fn padded<const D: usize>(v: &[f64; D]) -> [f64; 3] {
    array::from_fn(|i| v.get(i).copied().unwrap_or(0.0))
}

impl<'a, const D: usize> From<&'a Zonotope<D>> for Placed<'a, D> {
    #[inline]
    fn from(body: &'a Zonotope<D>) -> Self {
        Self::of_finite(body.center(), body.generators())
    }
}

impl<'a> From<&'a Zonotope<3>> for Placed<'a, 3, Pose> {
    #[inline]
    fn from(body: &'a Zonotope<3>) -> Self {
        body.at(&Pose::IDENTITY)
    }
}

impl Zonotope<3> {
    /// The body where a pose puts it, without a copy of its generators. O(1).
    #[inline]
    pub fn at(&self, pose: &Pose) -> Placed<'_, 3, Pose> {
        let placed: Placed<'_> = self.into();
        placed.at(pose)
    }
}

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
