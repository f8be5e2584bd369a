//! The box along orthogonal directions that a search finds.

use super::fitting::fit_box;
use super::shape::Shaped;
use super::zonotope::Zonotope3;
use crate::bvh::frame::Frame;
use crate::bvh::volume::BoundingVolume;
use crate::zonotope::Zonotope;

/// A box in any position, searched for the least expected number of overlaps: a zonotope of three orthogonal
/// generators, tested as one.
#[derive(Debug, Clone, PartialEq)]
pub struct OrientedBox(Zonotope3);

impl Shaped for OrientedBox {
    fn shape(&self) -> Zonotope<3> {
        self.0.shape()
    }

    fn margin(&self) -> f64 {
        self.0.margin()
    }
}

impl BoundingVolume for OrientedBox {
    const NAME: &'static str = "OBB";
    const IS_FITTED_TO_HULL: bool = true;
    type Prepared = Frame;

    fn around(points: &[[f64; 3]], _effort: usize) -> Self {
        Self(Zonotope3::of_fit(&fit_box(points), points))
    }

    fn refitted(&self, points: &[[f64; 3]]) -> Self {
        Self(self.0.refitted(points))
    }

    fn prepared(frame: &Frame) -> Frame {
        *frame
    }

    #[inline]
    fn gap(&self, other: &Self, frame: &Frame) -> f64 {
        self.0.gap(&other.0, frame)
    }

    #[inline]
    fn is_apart(&self, other: &Self, frame: &Frame, least: f64) -> bool {
        self.0.is_apart(&other.0, frame, least)
    }

    fn contains(&self, point: &[f64; 3]) -> bool {
        self.0.contains(point)
    }

    fn as_zonotope(&self) -> Zonotope<3> {
        self.0.as_zonotope()
    }

    fn expected_overlaps(&self) -> f64 {
        self.0.expected_overlaps()
    }
}
