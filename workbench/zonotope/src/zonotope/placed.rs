//! A body where it stands: its centre and generators, what was prepared of them, and the pose that puts it there.
//!
//! [`Standing`] is a type parameter with two values, so that the same code serves bodies under poses and bodies as they
//! are stored, and these pay nothing for the possibility of a pose.

use std::array;
use std::fmt;

use super::Zonotope;
use super::pose::Pose;
use super::prepared::PreparedBody;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::rows::{LaidOut, Rows};

/// Where a body stands: as it is stored ([`AtRest`]), or where a [`Pose`] puts it.
pub trait Standing: Copy + Default + fmt::Debug + PartialEq + Send + Sync + sealed::Sealed {
    /// Whether no value of the type is a pose.
    const IS_FIXED: bool;

    /// The pose, if there is one.
    fn pose(&self) -> Option<&Pose>;

    /// The same with another translation, if there is a pose; every coordinate is finite.
    #[doc(hidden)]
    fn with_translation(self, translation: [f64; 3]) -> Self;
}

mod sealed {
    /// No type outside of the library says where a body stands.
    pub trait Sealed {}

    impl Sealed for super::AtRest {}

    impl Sealed for super::Pose {}
}

/// The standing of a body that is taken as it is stored.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct AtRest;

impl Standing for AtRest {
    const IS_FIXED: bool = true;

    #[inline(always)]
    fn pose(&self) -> Option<&Pose> {
        None
    }

    fn with_translation(self, _: [f64; 3]) -> Self {
        self
    }
}

impl Standing for Pose {
    const IS_FIXED: bool = false;

    #[inline(always)]
    fn pose(&self) -> Option<&Pose> {
        Some(self)
    }

    fn with_translation(self, translation: [f64; 3]) -> Self {
        self.translated_to(translation)
    }
}

/// A body that questions are asked about, prepared or not, where it stands: references to its parts, nothing copied.
///
/// [`Zonotope::at`] and [`PreparedBody::at`] make one under a pose. Wherever one is expected, `&body` is the body as it
/// stands: bodies with and without a pose are asked about each other.
#[derive(Debug, Clone, Copy)]
pub struct Placed<'a, const D: usize = 3, P = AtRest> {
    center: [f64; D],
    generators: &'a [[f64; D]],
    /// What was prepared of the generators, in space.
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

    /// Where the body stands.
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

impl<'a, const D: usize> From<&'a Zonotope<D>> for Placed<'a, D> {
    #[inline]
    fn from(body: &'a Zonotope<D>) -> Self {
        Self::of_finite(body.center(), body.generators())
    }
}

impl<'a> From<&'a PreparedBody> for Placed<'a> {
    #[inline]
    fn from(prepared: &'a PreparedBody) -> Self {
        Self { laid_out: Some(prepared.laid_out()), ..Self::from(prepared.body()) }
    }
}

impl<'a> From<&'a Zonotope<3>> for Placed<'a, 3, Pose> {
    #[inline]
    fn from(body: &'a Zonotope<3>) -> Self {
        body.at(&Pose::IDENTITY)
    }
}

impl<'a> From<&'a PreparedBody> for Placed<'a, 3, Pose> {
    #[inline]
    fn from(body: &'a PreparedBody) -> Self {
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

impl PreparedBody {
    /// The body where a pose puts it, without a copy of anything: blocks serve under any pose. O(1).
    #[inline]
    pub fn at(&self, pose: &Pose) -> Placed<'_, 3, Pose> {
        self.placed().at(pose)
    }

    /// The body as it is stored. O(1).
    #[inline]
    pub fn placed(&self) -> Placed<'_> {
        self.into()
    }
}
