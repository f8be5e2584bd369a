//! Bounding volumes of nodes: one trait, which a hierarchy is generic over.
//!
//! A new volume is one file in `volumes/` with this trait, a row and a `pub mod` in `volumes/mod.rs`, a `pub use` in
//! `bvh/mod.rs`, and a line of the list in `tests/mod.rs`, which then holds it to all that is asked of a volume. To be
//! asked for by its name it needs a row of `method.rs`, which tests find in the manual and among the colours of
//! figures.

use super::frame::Frame;
use crate::zonotope::Zonotope;

/// A convex body around the points of a node.
///
/// Coordinates are in units of the mesh: points have coordinates of magnitude at most 1, and a volume reaches at most
/// [`REACH_LIMIT`](super::frame::REACH_LIMIT) along an axis.
///
/// # Example
/// ```
/// use zonotope::bvh::{Aabb, BoundingVolume};
/// let volume = Aabb::around(&[[0.0, 0.0, 0.0], [0.5, 0.25, 0.0]], 0);
/// assert!(volume.contains(&[0.25, 0.25, 0.0]) && !volume.contains(&[0.25, 0.25, 1.0]));
/// ```
pub trait BoundingVolume: Clone + std::fmt::Debug + Send + Sync {
    /// The name, for tables.
    const NAME: &'static str;

    /// Whether fitting takes time enough for the convex hull of the points to be worth it.
    const IS_FITTED_TO_HULL: bool;

    /// The numbers that a question about two hierarchies prepares once, for all its tests of pairs of nodes.
    type Prepared;

    /// A volume around points, of which there is at least one. `effort` bounds the steps of a search for a better
    /// one; 0 is the quickest fit.
    fn around(points: &[[f64; 3]], effort: usize) -> Self;

    /// A volume of the same shape around points that have moved.
    fn refitted(&self, points: &[[f64; 3]]) -> Self {
        Self::around(points, 0)
    }

    /// The numbers of a frame that tests of pairs of nodes read.
    fn prepared(frame: &Frame) -> Self::Prepared;

    /// The largest gap between this volume, of the first hierarchy, and one of the second, along the directions that
    /// the test tries; negative where none of them has a gap. A gap above [`Frame::slack`] proves that the volumes are
    /// disjoint, and how far apart at least, where these hold:
    ///
    /// - It is in units of the first mesh. Points of the second volume come by [`Frame::image`], vectors by
    ///   [`Frame::turned`], and lengths are multiplied by [`Frame::ratio`].
    /// - It is u · y − u · x, less the reaches, along a direction u of length at most 1. A distance of two points that
    ///   are computed to be nearest is none: it bounds the gap from above, so the gap along the line through them is
    ///   taken, whatever rounding has made of the points.
    /// - Its terms add up to at most 4 |s| + 128, s the frame's shift, and each goes through fewer than a hundred
    ///   roundings. Bodies that reach along a direction are bounded by the sum of what their parts reach.
    fn gap(&self, other: &Self, turned: &Self::Prepared) -> f64;

    /// Whether the gap is above a number: the answer of [`gap`](Self::gap), which a volume may give with less
    /// work.
    fn is_apart(&self, other: &Self, turned: &Self::Prepared, least: f64) -> bool {
        self.gap(other, turned) > least
    }

    /// Whether a point is inside, exactly.
    fn contains(&self, point: &[f64; 3]) -> bool;

    /// A zonotope that contains the volume, exactly.
    fn as_zonotope(&self) -> Zonotope<3>;

    /// The expected number of overlaps with its like in a random relative placement, up to a constant: V1 V2 + 2 V3 in
    /// intrinsic volumes, twice the mean width, half the surface and the volume, by the kinematic formula.
    fn expected_overlaps(&self) -> f64;
}

/// The rounding of a middle and a half, of extents of magnitude at most [`REACH_LIMIT`](super::frame::REACH_LIMIT).
pub(in crate::bvh) const ROUNDED_BOX: f64 = 64.0 * f64::EPSILON;

/// The box with these half-lengths along the axes, which are made larger by what rounding costs.
pub(in crate::bvh) fn box_around(center: [f64; 3], half: [f64; 3]) -> Zonotope<3> {
    let [a, b, c] = half.map(|c| c + ROUNDED_BOX);
    Zonotope::new(center, vec![[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]])
        .expect("a volume of finite points is finite")
}

/// V1 V2 + 2 V3 of a zonotope: V1 is twice the total half-length, V2 and V3 the sums of areas and volumes of the
/// parallelograms and parallelepipeds of its generators.
pub(in crate::bvh) fn expected_overlaps_of_generators(generators: &[[f64; 3]]) -> f64 {
    use crate::numeric::linear::{cross, dot, euclidean_norm};
    let (mut length, mut area, mut volume) = (0.0, 0.0, 0.0);
    for (k, c) in generators.iter().enumerate() {
        length += euclidean_norm(c);
        for (j, b) in generators[..k].iter().enumerate() {
            let normal = cross(b, c);
            area += euclidean_norm(&normal);
            volume += generators[..j].iter().map(|a| dot(a, &normal).abs()).sum::<f64>();
        }
    }
    2.0 * length * 4.0 * area + 2.0 * 8.0 * volume
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_expected_overlaps_of_a_box_by_hand() {
        // half-lengths 1, 2, 3: V1 = 12, V2 = 44, V3 = 48
        let found = expected_overlaps_of_generators(&[[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]]);
        assert_eq!(found, 12.0 * 44.0 + 2.0 * 48.0);
    }
}
