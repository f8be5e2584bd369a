//! The sphere around the middle of the box along the axes.

use std::f64::consts::PI;

use super::aabb::Aabb;
use crate::bvh::frame::Frame;
use crate::bvh::volume::{BoundingVolume, box_around};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{difference, dot, exact};
use crate::numeric::linear::{euclidean_norm, norm_of_any_size};
use crate::numeric::tolerance::ROUNDED_RADIUS;
use crate::zonotope::Zonotope;

/// A ball by its centre and radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    center: [f64; 3],
    radius: f64,
}

impl BoundingVolume for Sphere {
    const NAME: &'static str = "sphere";
    const IS_FITTED_TO_HULL: bool = false;
    type Prepared = Frame;

    fn around(points: &[[f64; 3]], effort: usize) -> Self {
        let center = Aabb::around(points, effort).center();
        let distance = |p: &[f64; 3]| euclidean_norm(&std::array::from_fn(|k| p[k] - center[k]));
        let farthest = points.iter().map(distance).fold(0.0, f64::max);
        Self { center, radius: farthest * (1.0 + ROUNDED_RADIUS) + ROUNDED_RADIUS * f64::EPSILON }
    }

    fn prepared(frame: &Frame) -> Frame {
        *frame
    }

    #[inline]
    fn gap(&self, other: &Self, frame: &Frame) -> f64 {
        let to = frame.image(&other.center);
        let apart = std::array::from_fn(|k| to[k] - self.center[k]);
        // the other mesh may be as far away as doubles go
        norm_of_any_size(&apart) - self.radius - frame.ratio * other.radius
    }

    fn contains(&self, point: &[f64; 3]) -> bool {
        let from_center = difference(&exact(*point), &exact(self.center));
        let radius = Dyadic::from_f64(self.radius);
        dot(&from_center, &from_center) <= &radius * &radius
    }

    fn as_zonotope(&self) -> Zonotope<3> {
        box_around(self.center, [self.radius; 3])
    }

    fn expected_overlaps(&self) -> f64 {
        let r = self.radius;
        (4.0 * r) * (2.0 * PI * r * r) + 2.0 * (4.0 / 3.0) * PI * r * r * r
    }
}
