//! Bodies under poses, put to the methods for posed bodies of space.
//!
//! A body of the line or of the plane is a slice of a prism over it: further generators along the coordinates that it
//! lacks. The displacement has none of these coordinates, so it lies relative to the prism as it does relative to the
//! body, with the same gauge, the same nearest points and, as the prism is higher than the bodies are wide, the same
//! depth. The generators of the prism are hidden again in the answer: their coefficients are 0.
//!
//! Bodies of more dimensions are asked about as their images, where doubles hold these.

use std::ops::Range;

use zonotope::Pose;
use zonotope::collision::distance::FeatureKind;
use zonotope::collision::{Gauge, Location, Query, Separation, Witness};
use zonotope::zonotope::Zonotope;

pub(super) use crate::fields::SPACE;
use crate::fields::{Fields, image_not_held};
use crate::place::Place;
use crate::placement::Placement;
use crate::refusal::Refusal;

/// The names of faces by their dimension.
const FEATURES: [FeatureKind; 3] = [FeatureKind::Vertex, FeatureKind::Edge, FeatureKind::Facet];

/// A zonotope of a question with the placement of its pose.
pub(super) struct Posed<const D: usize> {
    pub(super) body: Zonotope<D>,
    placement: Placement,
    /// The place of the pose in the question.
    place: Place,
}

impl<const D: usize> Posed<D> {
    /// The zonotope of an object whose centre goes by the name `center`.
    pub(super) fn read(fields: &Fields<'_>, center: &str) -> Result<Self, Refusal> {
        let body = Zonotope::new(fields.vector(center)?, fields.vectors("generators")?);
        Ok(Self {
            body: body.expect("what is not finite was refused when the question was read"),
            placement: fields.placement(D)?,
            place: fields.place_of("pose"),
        })
    }

    /// A point, which nothing places.
    pub(super) fn of_point(point: [f64; D]) -> Self {
        let body = Zonotope::new(point, Vec::new()).expect("what is not finite was refused when the question was read");
        Self { body, placement: Placement::identity(D), place: Place::default() }
    }

    /// The image, if doubles hold it; else a refusal, as no other image is taken in so many dimensions.
    pub(super) fn image(&self) -> Result<Zonotope<D>, Refusal> {
        self.placement.image(&self.body).ok_or_else(|| image_not_held(&self.place, D))
    }

    /// More than the width of the image along any axis; infinite beyond the range of doubles.
    fn reach(&self) -> f64 {
        let image = |v: &[f64; D]| -> f64 {
            self.placement.matrix().iter().flat_map(|row| row.iter().zip(v)).map(|(m, x)| (m * x).abs()).sum()
        };
        4.0 * self.body.generators().iter().map(image).sum::<f64>()
    }

    /// The body in space, with more generators there, which are stretched.
    fn in_space(&self, hidden: impl Iterator<Item = [f64; SPACE]>, stretch: f64) -> (Zonotope<SPACE>, Pose) {
        let space = |v: &[f64; D]| std::array::from_fn(|axis| v.get(axis).copied().unwrap_or_default());
        let generators = self.body.generators().iter().map(space).chain(hidden).collect::<Vec<_>>();
        let body = Zonotope::new(space(&self.body.center()), generators).expect("the body is finite");
        (body, self.placement.of_space(stretch))
    }
}

/// Two posed bodies of at most three dimensions as bodies of space, the first one a prism.
pub(super) struct Prism<const D: usize> {
    bodies: [(Zonotope<SPACE>, Pose); 2],
    hidden: Hidden<D>,
}

impl<const D: usize> Prism<D> {
    /// The prism over the first of two bodies, and the second body.
    pub(super) fn over(first: &Posed<D>, second: &Posed<D>) -> Self {
        // Products of doubles may leave their range, and so does the height then, as a product.
        let (height, stretch) = match first.reach() + second.reach() {
            0.0 => (1.0, 1.0),
            reach if reach.is_finite() => (reach, 1.0),
            _ => (f64::MAX, 2f64.powi(1000)),
        };
        let count = first.body.generators().len();
        let along = |axis: usize| std::array::from_fn(|other| if other == axis { height } else { 0.0 });
        let hidden = Hidden(count..count + SPACE.saturating_sub(D));
        let bodies = [first.in_space((D..SPACE).map(along), stretch), second.in_space(std::iter::empty(), 1.0)];
        Self { bodies, hidden }
    }

    /// The question about the two bodies.
    pub(super) fn query(&self) -> Query<'_, 3, Pose> {
        let [(a, from), (b, to)] = &self.bodies;
        Query::of_placed(a.at(from), b.at(to))
    }

    /// The question about the first body and a point.
    pub(super) fn query_of(&self, point: [f64; D]) -> Query<'_, 3, Pose> {
        let (body, pose) = &self.bodies[0];
        let point = std::array::from_fn(|axis| point.get(axis).copied().unwrap_or_default());
        Query::of_point_in(point, body.at(pose)).expect("the numbers of a question are finite")
    }

    /// The part that the answer hides.
    pub(super) fn hidden(&self) -> &Hidden<D> {
        &self.hidden
    }
}

/// The generators of a prism that are no generators of the body.
pub(super) struct Hidden<const D: usize>(Range<usize>);

impl<const D: usize> Hidden<D> {
    /// None.
    pub(super) const NONE: Self = Self(0..0);

    /// The coordinates that the body has.
    pub(super) fn vector<T: Clone, const S: usize>(&self, v: &[T; S]) -> [T; D] {
        std::array::from_fn(|axis| v[axis].clone())
    }

    /// A direction in the dimensions of the question: any where only that of the prism's height was found, as then all
    /// lead beyond the range of doubles.
    pub(super) fn direction<const S: usize>(&self, direction: &[f64; S]) -> [f64; D] {
        let mut own = self.vector(direction);
        if own.iter().all(|x| *x == 0.0) && direction.iter().any(|x| *x != 0.0) {
            own[0] = 1.0;
        }
        own
    }

    /// The proof about the generators of the question.
    pub(super) fn witness(&self, Witness { coefficients, basis }: &Witness) -> Witness {
        let is_shown = |index: &usize| !self.0.contains(index);
        let shown = coefficients.iter().enumerate().filter(|(index, _)| is_shown(index));
        let place = |&index: &usize| if index < self.0.start { index } else { index - self.0.len() };
        Witness {
            coefficients: shown.map(|(_, coefficient)| *coefficient).collect(),
            basis: basis.iter().filter(|index| is_shown(index)).map(place).collect(),
        }
    }

    /// The location in the dimensions of the question. What separates from the prism separates from the body without
    /// the coordinates that the displacement has not.
    pub(super) fn location(&self, location: &Location<SPACE>) -> Location<D> {
        match location {
            Location::Inside(witness) => Location::Inside(self.witness(witness)),
            Location::Boundary(witness) => Location::Boundary(self.witness(witness)),
            Location::Outside(Separation::Rounded(direction)) => {
                Location::Outside(Separation::Rounded(self.vector(direction)))
            }
            Location::Outside(Separation::Exact(direction)) => {
                Location::Outside(Separation::Exact(Box::new(self.vector(direction))))
            }
        }
    }

    /// The gauge in the dimensions of the question.
    pub(super) fn gauge(&self, gauge: &Gauge<SPACE>) -> Gauge<D> {
        Gauge { value: gauge.value, error: gauge.error, location: self.location(&gauge.location) }
    }

    /// The names of faces of both bodies; those of a prism have its generators as well.
    pub(super) fn features(&self, [first, second]: [FeatureKind; 2]) -> [&'static str; 2] {
        let dimension = FEATURES.iter().position(|kind| *kind == first).unwrap_or_default();
        [FEATURES[dimension.saturating_sub(self.0.len())].name(), second.name()]
    }
}
