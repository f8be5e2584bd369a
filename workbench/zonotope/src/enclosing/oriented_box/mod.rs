//! Small boxes around points of the plane and of space, with their sides in any orthogonal directions.
//!
//! A box is the zonotope of few generators that everybody knows. Here it is what zonotopes are compared with and what
//! the search for few generators begins with; nothing about it is proven.
//!
//! | file | which box | cost |
//! |---|---|---|
//! | [`in_the_plane`] | the rectangle of least area, by the edges of the hull | O(n log n + h²) for a hull of h vertices |
//! | [`in_space`] | a box of small volume, by a search over its axis | some hundred rectangles |

pub mod in_space;
pub mod in_the_plane;

pub use in_space::small_box;
pub use in_the_plane::smallest_rectangle;

use crate::numeric::linear::dot;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two, scaled_difference};

/// A box, in floating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrientedBox<const D: usize> {
    /// Orthonormal vectors along the sides.
    pub axes: [[f64; D]; D],
    /// Half the extent of the points along each axis.
    pub half_sides: [f64; D],
}

impl<const D: usize> OrientedBox<D> {
    /// The smallest box around points along orthonormal axes.
    pub fn along(points: &[[f64; D]], axes: [[f64; D]; D]) -> Self {
        Self { axes, half_sides: axes.map(|axis| half_extent(points, &axis)) }
    }

    /// The volume, or the area in the plane, of the box with the half-sides as sides.
    fn product(&self) -> f64 {
        self.half_sides.iter().product()
    }
}

/// Half the extent of points along a vector.
fn half_extent<const D: usize>(points: &[[f64; D]], along: &[f64; D]) -> f64 {
    let heights = points.iter().map(|p| dot(p, along));
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
    high / 2.0 - low / 2.0
}

/// Points relative to the first one, scaled by 2^−exponent to coordinates of at most 1, and that exponent.
fn in_units<const D: usize>(points: &[[f64; D]]) -> (Vec<[f64; D]>, i64) {
    let Some(first) = points.first() else { return (Vec::new(), 0) };
    let halves = |p: &[f64; D]| -> [f64; D] { std::array::from_fn(|c| p[c] / 2.0 - first[c] / 2.0) };
    let largest = points.iter().flat_map(halves).fold(0.0, |largest: f64, c| largest.max(c.abs()));
    let exponent = binary_exponent(largest).map_or(0, |e| i64::from(e) + 2);
    let scaled = |p: &[f64; D]| std::array::from_fn(|c| scaled_difference(p[c], first[c], -exponent));
    (points.iter().map(scaled).collect(), exponent)
}

/// The box in the units of points that were scaled by 2^−exponent.
fn out_of_units<const D: usize>(found: OrientedBox<D>, exponent: i64) -> OrientedBox<D> {
    OrientedBox { half_sides: found.half_sides.map(|half| scale_by_power_of_two(half, exponent)), ..found }
}
