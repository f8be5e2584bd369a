//! A query about bodies of space under poses: where they stand is part of the question, and their generators are never
//! copied.

use std::sync::OnceLock;

use super::pose::Pose;
use super::prepared::{self, BodyView};
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, difference};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::max_norm;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::tolerance::{DISPLACEMENT_ACCURACY, PRODUCT_UNDERFLOW, UNIT};

/// Where is an exact displacement relative to the zonotope { Σ δ_i M g_i : |δ_i| ≤ 1 } of posed generators?
///
/// The generators come in two slices with a pose each; a generator's index counts through the first slice and then the
/// second.
#[derive(Debug, Clone)]
pub struct PosedQuery<'a> {
    /// The displacement leads from the image of the first point under the first pose to that of the second.
    points: [[f64; 3]; 2],
    poses: [Pose; 2],
    generators: [Rows<'a>; 2],
    /// Made when it is asked for: most questions are answered in doubles, and exact products cost more than those.
    displacement: OnceLock<ExactVector>,
}

impl<'a> PosedQuery<'a> {
    /// Membership of a point in a posed body, prepared or not: from the image of its centre to the point. O(1).
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is not finite.
    pub fn of_point(point: [f64; 3], body: impl Into<BodyView<'a>>, pose: &Pose) -> Result<Self, NonFinite> {
        NonFinite::check_vector("the end", &point)?;
        let (center, rows) = center_and_rows(body.into());
        Ok(Self::new([center, point], [*pose, Pose::IDENTITY], [rows, Rows::NONE]))
    }

    /// Intersection of two posed bodies, each prepared or not (Lemma 5.1): from the image of the first one's centre to
    /// that of the second, relative to the posed generators of both. O(1).
    pub fn between(
        (first, from): (impl Into<BodyView<'a>>, &Pose),
        (second, to): (impl Into<BodyView<'a>>, &Pose),
    ) -> Self {
        let ((a, own), (b, others)) = (center_and_rows(first.into()), center_and_rows(second.into()));
        Self::new([a, b], [*from, *to], [own, others])
    }

    /// A query about generators in two runs, each with the point that stands for its body; all finite. O(1).
    pub(crate) fn of_runs(points: [[f64; 3]; 2], poses: [Pose; 2], runs: [&'a [[f64; 3]]; 2]) -> Self {
        Self::new(points, poses, runs.map(Rows::new))
    }

    fn new(points: [[f64; 3]; 2], poses: [Pose; 2], generators: [Rows<'a>; 2]) -> Self {
        Self { points, poses, generators, displacement: OnceLock::new() }
    }

    /// The displacement, exactly: the image of a centre under a pose is seldom a vector of doubles.
    pub fn displacement(&self) -> &ExactVector {
        self.displacement.get_or_init(|| {
            let [from, to] = self.ends();
            difference(&to, &from)
        })
    }

    /// Where the displacement starts and ends, exactly.
    pub(crate) fn ends(&self) -> [ExactVector; 2] {
        [0, 1].map(|i| self.poses[i].exact_point(self.points[i]))
    }

    /// The displacement by plain sums of doubles, with a bound of each coordinate's error: that of the terms, which may
    /// be far larger than their sum.
    #[inline]
    pub(crate) fn displacement_estimate(&self) -> BoundedVector {
        let [[a, b, c], [d, e, f]] =
            [self.poses[0].rounded_point(&self.points[0]), self.poses[1].rounded_point(&self.points[1])];
        // a coordinate goes through five roundings
        let difference = |(from, size): (f64, f64), (to, other): (f64, f64)| Bounded {
            value: to - from,
            error: 8.0 * UNIT * (size + other) + PRODUCT_UNDERFLOW,
        };
        [difference(a, d), difference(b, e), difference(c, f)]
    }

    /// The displacement to twice the digits of a double.
    pub(crate) fn displacement_pairs(&self) -> [BoundedDoubleDouble; 3] {
        let of = BoundedDoubleDouble::exact;
        let [from, to] = [0, 1].map(|i| {
            let image = self.poses[i].pair_image(&self.points[i].map(of));
            let translation = self.poses[i].translation();
            [0, 1, 2].map(|k| image[k] + of(translation[k]))
        });
        [0, 1, 2].map(|k| to[k] - from[k])
    }

    /// The displacement in doubles, with a bound of each coordinate's error that is small beside the largest
    /// coordinate.
    pub(crate) fn rounded_displacement(&self) -> BoundedVector {
        let p = self.displacement_pairs().map(|pair| pair.rounded());
        let limit = DISPLACEMENT_ACCURACY * max_norm(&p.map(|c| c.value));
        // false for NaN as well
        let is_known = p.iter().all(|c| c.error < limit);
        if is_known { p } else { self.displacement().each_ref().map(rounded) }
    }

    /// The generators as they are stored, in two runs.
    pub fn runs(&self) -> [&'a [[f64; 3]]; 2] {
        self.generators.map(Rows::list)
    }

    /// The generators as passes take them.
    #[inline(always)]
    pub(crate) fn rows(&self) -> [Rows<'a>; 2] {
        self.generators
    }

    /// The pose of each run.
    pub fn poses(&self) -> [Pose; 2] {
        self.poses
    }

    /// The pose of each run, without a copy.
    #[inline]
    pub(crate) fn own_poses(&self) -> &[Pose; 2] {
        &self.poses
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

#[inline]
fn center_and_rows(body: BodyView<'_>) -> ([f64; 3], Rows<'_>) {
    (body.body().center(), prepared::rows(body.body().generators(), body.laid_out()))
}

/// An exact number in doubles.
fn rounded(exact: &Dyadic) -> Bounded {
    let value = exact.to_f64();
    let is_exact = value.is_finite() && Dyadic::from_f64(value) == *exact;
    Bounded { value, error: if is_exact { 0.0 } else { 4.0 * f64::EPSILON * value.abs() + f64::from_bits(1) } }
}
