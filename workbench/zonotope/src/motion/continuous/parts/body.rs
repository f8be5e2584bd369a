//! A body with the sum that bounds the rounding of passes over its generators.

use crate::motion::scalar::ReachScalar;
use crate::numeric::lanes::extreme_sums;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{dot, sum_norm};
use crate::numeric::tolerance::LONG_SUM;
use crate::zonotope::Zonotope;

/// A body of space: a centre with generators, or with corners whose hull it adds; and a bound of their sizes.
///
/// A zonotope has no corners, a triangle no generators.
#[derive(Debug, Clone, Copy)]
pub(in crate::motion::continuous) struct Body<'a> {
    center: [f64; 3],
    generators: &'a [[f64; 3]],
    corners: &'a [[f64; 3]],
    magnitude: f64,
}

/// On which side of a body a direction leaves it: of bodies with corners both sides differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::motion::continuous) enum Side {
    /// The direction leads away from the body.
    Away,
    /// The direction leads to the body.
    Toward,
}

impl<'a> Body<'a> {
    pub(in crate::motion::continuous) fn of(zonotope: &'a Zonotope<3>) -> Self {
        let generators = zonotope.generators();
        let magnitude: f64 = generators.iter().flatten().map(|c| c.abs()).sum();
        Self { center: zonotope.center(), generators, corners: &[], magnitude: magnitude * LONG_SUM }
    }

    /// The hull of corners, of which there is at least one.
    pub(in crate::motion::continuous) fn hull_of(corners: &'a [[f64; 3]]) -> Self {
        let magnitude = corners.iter().map(sum_norm).fold(0.0, f64::max);
        Self { center: [0.0; 3], generators: &[], corners, magnitude: magnitude * LONG_SUM }
    }

    pub(in crate::motion::continuous) fn generators(&self) -> &'a [[f64; 3]] {
        self.generators
    }

    pub(in crate::motion::continuous) fn center(&self) -> [f64; 3] {
        self.center
    }

    /// A bound above Σ |g|_1 and the largest |p|_1, but for overflow.
    pub(in crate::motion::continuous) fn magnitude(&self) -> f64 {
        self.magnitude
    }

    /// The generators and corners that a support value reads.
    pub(in crate::motion::continuous) fn terms(&self) -> usize {
        self.generators.len() + self.corners.len()
    }

    /// The edges of a body: generators, or the differences of corners.
    pub(in crate::motion::continuous) fn edges(&self) -> Vec<[f64; 3]> {
        let pairs = (0..self.corners.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
        let between = pairs.map(|[i, j]| [0, 1, 2].map(|k| self.corners[j][k] - self.corners[i][k]));
        self.generators.iter().copied().chain(between).collect()
    }

    /// The reach of the body from its centre on one side, for each direction: Σ |u · g|, and the largest u · p.
    pub(in crate::motion::continuous) fn reaches<T: ReachScalar, const K: usize>(
        &self,
        side: Side,
        directions: &[[T; 3]; K],
    ) -> [T; K] {
        let sums = T::reaches(self.generators, self.magnitude, directions);
        if self.corners.is_empty() {
            return sums;
        }
        let corners = || self.corners.iter().map(|corner| corner.map(T::of));
        let farthest = |u: &[T; 3]| match side {
            Side::Away => T::largest(corners().map(|p| dot(u, &p))),
            Side::Toward => T::largest(corners().map(|p| T::ZERO.minus(&dot(u, &p)))),
        };
        std::array::from_fn(|k| sums[k].plus(&farthest(&directions[k])))
    }

    /// The vectors from the centre to the points that are farthest along directions on one side; on the side that a
    /// direction leads to, their opposites.
    pub(in crate::motion::continuous) fn farthest<const K: usize>(
        &self,
        side: Side,
        directions: &[[f64; 3]; K],
    ) -> [[f64; 3]; K] {
        let sums = extreme_sums(Rows::new(self.generators), directions);
        if self.corners.is_empty() {
            return sums;
        }
        let sign = if side == Side::Away { 1.0 } else { -1.0 };
        let corner = |u: &[f64; 3]| {
            let along = |p: &[f64; 3]| sign * dot(u, p);
            let best = self.corners.iter().max_by(|p, q| along(p).total_cmp(&along(q)));
            best.map_or([0.0; 3], |p| p.map(|c| sign * c))
        };
        std::array::from_fn(|k| {
            let corner = corner(&directions[k]);
            [0, 1, 2].map(|axis| sums[k][axis] + corner[axis])
        })
    }
}
