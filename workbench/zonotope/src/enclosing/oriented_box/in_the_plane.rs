//! The rectangle of least area around points of the plane, in floating point.
//!
//! It has a side along an edge of the convex hull, so every edge is tried.

use super::{OrientedBox, in_units, out_of_units};
use crate::hull::by_monotone_chain::convex_hull;
use crate::numeric::linear::dot;

/// The rectangle of least area around points; `None` where all are equal, there are none, or a number is not finite.
///
/// # Example
/// ```
/// use zonotope::enclosing::oriented_box::smallest_rectangle;
/// // a diamond is a square
/// let diamond = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
/// let found = smallest_rectangle(&diamond).expect("a square");
/// assert!(found.half_sides.iter().all(|half| (half - 0.5f64.sqrt()).abs() < 1e-15));
/// ```
pub fn smallest_rectangle(points: &[[f64; 2]]) -> Option<OrientedBox<2>> {
    let hull = convex_hull(points, &mut ()).ok()?;
    let (corners, exponent) = in_units(hull.vertices());
    let rectangle = |i: usize| {
        let next = corners[(i + 1) % corners.len()];
        let edge = [next[0] - corners[i][0], next[1] - corners[i][1]];
        let length = dot(&edge, &edge).sqrt();
        let along = edge.map(|c| c / length);
        OrientedBox::along(&corners, [along, [-along[1], along[0]]])
    };
    let rectangles = (0..corners.len()).map(rectangle).filter(|found| found.product().is_finite());
    let least = rectangles.min_by(|a, b| a.product().total_cmp(&b.product()))?;
    Some(out_of_units(least, exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_half_of_its_rectangle_at_any_scale() {
        for scale in [1.0, 1e-300, 1e300] {
            let found = smallest_rectangle(&[[0.0, 0.0], [3.0 * scale, 0.0], [0.0, 4.0 * scale]]).expect("a rectangle");
            let halves = found.half_sides.map(|half| half / scale);
            assert!((halves[0] * halves[1] - 3.0).abs() < 1e-12, "{found:?}");
        }
        let segment = smallest_rectangle(&[[0.0, 0.0], [1.0, 0.0], [4.0, 0.0]]).expect("a segment");
        assert_eq!(segment.half_sides, [2.0, 0.0]);
        assert_eq!(smallest_rectangle(&[[1.0, 2.0], [1.0, 2.0]]), None);
        assert_eq!(smallest_rectangle(&[]), None);
    }
}
