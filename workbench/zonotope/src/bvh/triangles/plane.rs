//! A triangle in doubles with its plane, which proves most of the triangles near it disjoint from it.
//!
//! # Derivation of the bound
//!
//! The height of a corner c over the plane through p, q, r is the determinant of the edges q − p, r − p and of c − p, a
//! sum of six products. Let the coordinates of these three vectors have magnitudes of at most A, B and C with all their
//! errors: those of the first two are off by twice the error e of a corner of the triangle, those of the third by e and
//! the error f of a corner of the other one. Then the height is off by 6 (2 e (B C + A C) + (e + f) A B), and rounding
//! adds [`HEIGHT_OVER_PLANE`] times 6 A B C.

use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::linear::{cross, dot, max_norm};
use crate::numeric::tolerance::{HEIGHT_OVER_PLANE, PRODUCT_UNDERFLOW, THIRTY_ROUNDINGS};

/// Three corners, each coordinate off by at most one error.
#[derive(Debug, Clone, Copy)]
pub(in crate::bvh) struct Corners {
    pub(in crate::bvh) values: [[f64; 3]; 3],
    pub(in crate::bvh) error: f64,
}

/// A triangle with its plane.
#[derive(Debug, Clone, Copy)]
pub(in crate::bvh) struct Planar {
    pub(in crate::bvh) corners: Corners,
    normal: [f64; 3],
    /// A and B.
    edges: [f64; 2],
}

impl Corners {
    /// The corners as bounded doubles.
    pub(in crate::bvh) fn bounded(&self) -> [BoundedVector; 3] {
        self.values.map(|corner| corner.map(|value| Bounded { value, error: self.error }))
    }

    /// The triangle with its plane.
    #[inline]
    pub(in crate::bvh) fn with_plane(self) -> Planar {
        let [p, q, r] = &self.values;
        let edges = [difference(p, q), difference(p, r)];
        let normal = cross(&edges[0], &edges[1]);
        Planar { corners: self, normal, edges: edges.map(|edge| max_norm(&edge) + 2.0 * self.error) }
    }
}

impl Planar {
    /// Whether all corners of another triangle are proved to lie on one side of the plane.
    #[inline]
    pub(in crate::bvh) fn has_beside(&self, other: &Corners) -> bool {
        let apart = other.values.each_ref().map(|corner| difference(&self.corners.values[0], corner));
        let heights = apart.each_ref().map(|d| dot(&self.normal, d));
        let ([a, b], of_difference) = (self.edges, self.corners.error + other.error);
        let c = apart.iter().map(max_norm).fold(0.0, f64::max) + of_difference;
        let carried = 2.0 * self.corners.error * (a + b) * c + of_difference * a * b;
        let bound = 6.0 * THIRTY_ROUNDINGS * (carried + HEIGHT_OVER_PLANE * a * b * c) + PRODUCT_UNDERFLOW * (1.0 + c);
        heights.iter().all(|height| *height > bound) || heights.iter().all(|height| *height < -bound)
    }
}

/// `to` − `from`.
#[inline(always)]
fn difference(from: &[f64; 3], to: &[f64; 3]) -> [f64; 3] {
    [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}
