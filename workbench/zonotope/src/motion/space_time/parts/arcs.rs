//! Points of the plane around the arcs of circles on which the vertices of a shadow move, each taken from where it
//! begins.
//!
//! A vertex x moves to R(φ) x, and R(φ) x − x is linear in x. An arc lies in the hull of points of it and of the
//! corners of the tangents at these points. So for each of a few 2 × 2 matrices the images of all vertices are taken:
//! their hull holds all arcs.

use std::f64::consts::PI;

use super::angle::covering;
use super::shadow::Shadow;
use crate::numeric::tolerance::{ARC_POINT_ROUNDING, ARC_POINT_UNDERFLOW};

/// The largest angle between two points of an arc: there the corner of the tangents is 0.5 % beyond the arc.
const STEP: f64 = PI / 16.0;

/// Points whose hull holds the arcs but for a distance.
#[derive(Debug)]
pub(in super::super) struct ArcPoints {
    pub(in super::super) points: Vec<[f64; 2]>,
    /// The hull and a disc of this radius hold every arc.
    pub(in super::super) off: f64,
}

impl ArcPoints {
    /// The points around the arcs of an angle.
    pub(in super::super) fn of(shadow: &Shadow, angle: f64) -> Self {
        let angle = covering(angle);
        let count = (angle / STEP).ceil().max(1.0);
        let half = angle / count / 2.0;
        let mut matrices = Vec::new();
        for i in 0..=(2.0 * count) as u32 {
            let middle = f64::from(i) * half;
            let length = if i % 2 == 0 { 1.0 } else { 1.0 / libm::cos(half) };
            matrices.push([libm::cos(middle) * length - 1.0, libm::sin(middle) * length]);
        }
        let mut points = Vec::with_capacity(matrices.len() * shadow.vertex_count());
        let mut size: f64 = 0.0;
        shadow.each_vertex(|[x, y]| {
            size = size.max(x.abs() + y.abs());
            points.extend(matrices.iter().map(|[c, s]| [c * x - s * y, s * x + c * y]));
        });
        // an arc that is not a point may have coordinates that are rounded to multiples of the smallest double
        let underflow = if size == 0.0 { 0.0 } else { ARC_POINT_UNDERFLOW };
        Self { points, off: ARC_POINT_ROUNDING * size + underflow + 3.0 * shadow.off() }
    }
}
