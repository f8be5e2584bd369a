//! A box of small volume around points of space, by a search over the direction of one side.
//!
//! # Statement
//! Input: points of space. Output: a box around them in floating point, the smallest that the search finds; points that
//! do not span space have none. That no box is smaller is not proven. The answer depends on the corners of the convex
//! hull alone, not on the order of the points.
//!
//! # Source
//! No part of the paper: a box is a zonotope of three generators, which others are compared with.
//!
//! # Method
//! 1. Take the corners of the hull, of many those that are farthest along the corners of a net of directions.
//! 2. For each axis to try, the smallest box with a side along it is the smallest rectangle around the projection
//!    across, times the extent along it. The axes are the corners of a coarser net, the coordinate axes among them, and
//!    the normals of the largest triangles of the hull: a small box often has a side on a facet.
//! 3. Move the best axis by an angle to four sides while the box gets smaller, then halve the angle.
//! 4. Make the box of that axis around all corners of the hull, and those of the coordinate axes: the smallest of them
//!    is the answer.
//!
//! # Complexity
//! O(n log n) for the hull; some hundred rectangles around some hundred points.
//!
//! # Shapes
//! `points`: n × 3, any order, duplicates allowed; `half_sides`: half-lengths.
//!
//! # Numerics
//! All in floating point, of coordinates scaled by a power of two; the hull is exact.
//!
//! # Errors
//! `None` ⇔ the points do not span space, are too many for a hull, or a number is not finite.
//!
//! # Checked by
//! Boxes in turned positions, which are found to rounding.
//!
//! # Example
//! ```
//! use zonotope::enclosing::oriented_box::small_box;
//! let prism = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(|[x, y]| [[x, y, 0.0], [x, y, 3.0]]);
//! let found = small_box(prism.as_flattened()).expect("a square prism");
//! let eighth: f64 = found.half_sides.iter().product();
//! assert!((8.0 * eighth - 6.0).abs() < 1e-12); // the square has the area 2
//! ```

use super::{OrientedBox, in_units, out_of_units, smallest_rectangle};
use crate::hull::in_space::{SolidHull, solid_hull};
use crate::numeric::linear::{cross, dot};
use crate::zonotope::directions::cube_faces::cell_corners;

/// The search goes by the points that are farthest along the corners of a net of so many cells.
const FAR_POINT_CELLS: usize = 10;

/// Of at most so many corners of the hull, the search goes by all.
const FAR_POINT_LIMIT: usize = 600;

/// The axes that the search begins with are the corners of a net of so many cells.
const AXIS_CELLS: usize = 4;

/// The search begins with the normals of at most so many triangles of the hull, the largest ones.
const TRIANGLE_LIMIT: usize = 100;

/// The axis moves by an angle that begins with this and is halved where no move helps.
const FIRST_ANGLE: f64 = 0.2;

/// The axis stops moving once the angle is less than this.
const LAST_ANGLE: f64 = 1e-3;

/// The axis moves at most so often: on few points it moves some ten times, and rounding must not keep it moving.
const STEP_LIMIT: usize = 400;

/// The smallest box around points that the search finds.
pub fn small_box(points: &[[f64; 3]]) -> Option<OrientedBox<3>> {
    let hull = solid_hull(points).ok()??;
    let mut corners: Vec<[f64; 3]> = hull.vertices().into_iter().map(|corner| points[corner]).collect();
    corners.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(p[2].total_cmp(&q[2])));
    let (corners, exponent) = in_units(&corners);
    let far = if corners.len() <= FAR_POINT_LIMIT { corners.clone() } else { far_points(&corners) };
    let axes = cell_corners::<3>(AXIS_CELLS).into_iter().chain(largest_normals(&hull, points));
    let mut best: Option<OrientedBox<3>> = None;
    let nearer = |axis: [f64; 3], best: &mut Option<OrientedBox<3>>| {
        let Some(found) = box_along(&far, &axis) else { return false };
        let is_smaller = best.is_none_or(|least| found.product() < least.product());
        if is_smaller {
            *best = Some(found);
        }
        is_smaller
    };
    for axis in axes {
        nearer(axis, &mut best);
    }
    let mut angle = FIRST_ANGLE;
    for _ in 0..STEP_LIMIT {
        if angle <= LAST_ANGLE {
            break;
        }
        let [axis, a, b] = best?.axes;
        let mut moves = [a, b].into_iter().flat_map(|v| [angle, -angle].map(|turn| (v, turn)));
        let moved = |v: [f64; 3], turn: f64| std::array::from_fn(|c| axis[c] + turn * v[c]);
        if !moves.any(|(v, turn)| nearer(moved(v, turn), &mut best)) {
            angle /= 2.0;
        }
    }
    // What is smallest around the far points need not be so around all: no box along a coordinate axis is smaller.
    let coordinate_axes = (0..3).map(|axis| std::array::from_fn(|c| f64::from(u8::from(c == axis))));
    let last = coordinate_axes.chain([best?.axes[0]]).filter_map(|axis| box_along(&corners, &axis));
    let least = last.min_by(|a, b| a.product().total_cmp(&b.product()))?;
    Some(out_of_units(least, exponent))
}

/// The normals of the largest triangles of a hull.
fn largest_normals(hull: &SolidHull, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let corners: Vec<[f64; 3]> = hull.triangles().iter().flatten().map(|&corner| points[corner]).collect();
    let (corners, _) = in_units(&corners);
    let normal = |[a, b, c]: &[[f64; 3]; 3]| {
        let sides = [b, c].map(|p| std::array::from_fn(|i| p[i] - a[i]));
        cross(&sides[0], &sides[1])
    };
    let mut normals: Vec<[f64; 3]> = corners.as_chunks::<3>().0.iter().map(normal).collect();
    normals.sort_by(|a, b| dot(b, b).total_cmp(&dot(a, a)));
    normals.truncate(TRIANGLE_LIMIT);
    normals
}

/// The points that are farthest along the corners of a net, and opposite to them.
fn far_points(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut far = Vec::new();
    for u in cell_corners::<3>(FAR_POINT_CELLS) {
        let order = |a: &&[f64; 3], b: &&[f64; 3]| dot(a, &u).total_cmp(&dot(b, &u));
        far.extend(points.iter().max_by(order));
        far.extend(points.iter().min_by(order));
    }
    far
}

/// The smallest box around points with a side along an axis.
fn box_along(points: &[[f64; 3]], axis: &[f64; 3]) -> Option<OrientedBox<3>> {
    let [along, a, b] = frame_of(axis)?;
    let shadow: Vec<[f64; 2]> = points.iter().map(|p| [dot(p, &a), dot(p, &b)]).collect();
    let in_space = |[x, y]: [f64; 2]| std::array::from_fn(|c| x * a[c] + y * b[c]);
    let [first, second] = smallest_rectangle(&shadow)?.axes.map(in_space);
    Some(OrientedBox::along(points, [along, first, second])).filter(|found| found.product().is_finite())
}

/// An orthonormal frame whose first vector is along the given one.
fn frame_of(v: &[f64; 3]) -> Option<[[f64; 3]; 3]> {
    let unit = |v: [f64; 3]| {
        let length = dot(&v, &v).sqrt();
        (length > 0.0 && length.is_finite()).then(|| v.map(|c| c / length))
    };
    let along = unit(*v)?;
    let least = (0..3).min_by(|&a, &b| along[a].abs().total_cmp(&along[b].abs()))?;
    let off: [f64; 3] = std::array::from_fn(|c| f64::from(u8::from(c == least)) - along[least] * along[c]);
    let a = unit(off)?;
    Some([along, a, cross(&along, &a)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of a box with sides of 4, 2 and 1 along orthogonal vectors, and its half-sides.
    fn turned_box(scale: f64) -> Vec<[f64; 3]> {
        let sides = [[2.0, 1.0, 2.0], [-2.0, 2.0, 1.0], [1.0, 2.0, -2.0]];
        let corner = |i: usize| -> [f64; 3] {
            let along = |k: usize| f64::from(u8::from(i >> k & 1 == 1)) * [4.0, 2.0, 1.0][k] / 3.0;
            std::array::from_fn(|c| (0..3).map(|k| along(k) * sides[k][c]).sum::<f64>() * scale)
        };
        (0..8).map(corner).collect()
    }

    #[test]
    fn a_turned_box_is_found_at_any_scale_and_in_any_order() {
        for scale in [1.0, 1e-300, 1e300] {
            let mut points = turned_box(scale);
            let found = small_box(&points).expect("a box");
            let mut halves = found.half_sides.map(|half| half / scale);
            halves.sort_by(f64::total_cmp);
            let errors = [halves[0] - 0.5, halves[1] - 1.0, halves[2] - 2.0].map(f64::abs);
            assert!(errors.iter().all(|error| *error < 1e-9), "{found:?}");
            points.rotate_left(3);
            points.push(points[2]);
            assert_eq!(small_box(&points).map(|again| again.half_sides), Some(found.half_sides));
        }
    }

    #[test]
    fn flat_points_have_no_box() {
        assert_eq!(small_box(&[[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0]]), None);
        assert_eq!(small_box(&[]), None);
        assert_eq!(small_box(&[[f64::NAN; 3]; 4]), None);
    }
}
