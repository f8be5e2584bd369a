//! Zonotopes of three to six generators: as many at each node as the predicted cost of a question is least with.
//!
//! A generator more makes a node overlap others less often and each test of it take longer. How much less differs from
//! node to node: a flat patch has no use for a fourth generator, and a round one for six.

use super::fitting::fit_by_cost;
use super::shape::Shaped;
use super::zonotope::{Used, Zonotope};
use crate::bvh::frame::Frame;
use crate::bvh::volume::BoundingVolume;
use crate::zonotope::Zonotope as Body;

/// The most generators of a node: the normals of more fill a third block.
const MOST_GENERATORS: usize = 6;

/// Weights of a test of two nodes of three, four, five and six generators, in terms of the first.
///
/// They grow faster than the times of the tests: triangles are tested whatever the bodies around them, and the nearer
/// two meshes are, the less is won by tighter bodies.
const COSTS_OF_TESTS: [f64; 4] = [1.0, 1.2, 1.2, 1.3];

/// A zonotope of at most six generators, whose number is chosen by cost.
#[derive(Debug, Clone, PartialEq)]
pub struct ZonotopeByCost {
    body: Zonotope<MOST_GENERATORS, 2>,
    used: Used,
}

impl ZonotopeByCost {
    fn of(body: Zonotope<MOST_GENERATORS, 2>) -> Self {
        Self { used: body.used(), body }
    }

    /// The number of generators.
    pub fn generator_count(&self) -> usize {
        self.used.generators
    }
}

impl Shaped for ZonotopeByCost {
    fn shape(&self) -> Body<3> {
        self.body.shape()
    }

    fn margin(&self) -> f64 {
        self.body.margin()
    }
}

impl BoundingVolume for ZonotopeByCost {
    const NAME: &'static str = "zonotope, K by cost";
    const IS_FITTED_TO_HULL: bool = true;
    type Prepared = Frame;

    fn around(points: &[[f64; 3]], effort: usize) -> Self {
        let cost = |generators: usize| COSTS_OF_TESTS[generators.clamp(3, MOST_GENERATORS) - 3];
        Self::of(Zonotope::of_fit(&fit_by_cost(points, MOST_GENERATORS, cost, effort), points))
    }

    fn refitted(&self, points: &[[f64; 3]]) -> Self {
        Self::of(self.body.refitted(points))
    }

    fn prepared(frame: &Frame) -> Frame {
        *frame
    }

    #[inline]
    fn gap(&self, other: &Self, frame: &Frame) -> f64 {
        self.body.gap_of_used(&other.body, frame, [self.used, other.used], f64::INFINITY)
    }

    #[inline]
    fn is_apart(&self, other: &Self, frame: &Frame, least: f64) -> bool {
        self.body.gap_of_used(&other.body, frame, [self.used, other.used], least) > least
    }

    fn contains(&self, point: &[f64; 3]) -> bool {
        self.body.contains(point)
    }

    fn as_zonotope(&self) -> Body<3> {
        self.body.as_zonotope()
    }

    fn expected_overlaps(&self) -> f64 {
        self.body.expected_overlaps()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count_around(points: &[[f64; 3]]) -> usize {
        ZonotopeByCost::around(points, 0).generator_count()
    }

    #[test]
    fn a_box_has_three_generators_and_a_round_body_more() {
        let corners: Vec<[f64; 3]> =
            (0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 0 { -0.5 } else { 0.5 })).collect();
        assert_eq!(count_around(&corners), 3);
        assert_eq!(count_around(&corners[..3]), 3);
        let round: Vec<[f64; 3]> = (0..200)
            .map(|i| {
                let (z, angle) = (f64::from(i) / 100.0 - 0.995, 2.4 * f64::from(i));
                let radius = 0.5 * (1.0 - z * z).sqrt();
                [radius * libm::cos(angle), radius * libm::sin(angle), 0.5 * z]
            })
            .collect();
        assert!((4..=MOST_GENERATORS).contains(&count_around(&round)), "{}", count_around(&round));
    }
}
