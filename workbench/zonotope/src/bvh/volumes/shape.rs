//! Volumes that are zonotopes of few generators.
//!
//! A volume is its shape and a margin: a cube, which takes up the rounding of the fit. The shape is for pictures, the
//! sum of both contains the triangles exactly.

use crate::bvh::volume::BoundingVolume;
use crate::zonotope::Zonotope;

/// A bounding volume that is a zonotope of few generators beside a margin.
pub trait Shaped: BoundingVolume {
    /// The body without its margin, for pictures: it may miss its points by rounding.
    fn shape(&self) -> Zonotope<3>;

    /// The number m such that the shape and the cube [−m, m]³ sum up to a body that contains the points exactly.
    fn margin(&self) -> f64;
}
