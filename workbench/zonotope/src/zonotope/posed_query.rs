//! A query about bodies of space under poses: where they stand is part of the question, and their generators are never
//! copied.

use super::implicit::Zonotope;
use super::pose::Pose;
use crate::numeric::exact_linear::{ExactVector, difference, exact};
use crate::numeric::non_finite::NonFinite;

/// Where is an exact displacement relative to the zonotope { Σ δ_i M g_i : |δ_i| ≤ 1 } of posed generators?
///
/// The generators come in two slices with a pose each; a generator's index counts through the first slice and then the
/// second.
#[derive(Debug, Clone)]
pub struct PosedQuery<'a> {
    displacement: ExactVector,
    generators: [&'a [[f64; 3]]; 2],
    poses: [Pose; 2],
}

impl<'a> PosedQuery<'a> {
    /// Membership of a point in a posed body: from the image of its centre to the point. O(1).
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is not finite.
    pub fn of_point(point: [f64; 3], body: &'a Zonotope<3>, pose: &Pose) -> Result<Self, NonFinite> {
        NonFinite::check_vector("the end", &point)?;
        let displacement = difference(&exact(point), &pose.exact_point(body.center()));
        Ok(Self::new(displacement, [body.generators(), &[]], [*pose, Pose::IDENTITY]))
    }

    /// Intersection of two posed bodies (Lemma 5.1): from the image of the first one's centre to that of the second,
    /// relative to the posed generators of both. O(1).
    pub fn between(first: (&'a Zonotope<3>, &Pose), second: (&'a Zonotope<3>, &Pose)) -> Self {
        let [(a, from), (b, to)] = [first, second];
        let displacement = difference(&to.exact_point(b.center()), &from.exact_point(a.center()));
        Self::new(displacement, [a.generators(), b.generators()], [*from, *to])
    }

    fn new(displacement: ExactVector, generators: [&'a [[f64; 3]]; 2], poses: [Pose; 2]) -> Self {
        Self { displacement, generators, poses }
    }

    /// The displacement, exactly: the image of a centre under a pose is seldom a vector of doubles.
    pub fn displacement(&self) -> &ExactVector {
        &self.displacement
    }

    /// The generators as they are stored, in two runs.
    pub fn runs(&self) -> [&'a [[f64; 3]]; 2] {
        self.generators
    }

    /// The pose of each run.
    pub fn poses(&self) -> [Pose; 2] {
        self.poses
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
