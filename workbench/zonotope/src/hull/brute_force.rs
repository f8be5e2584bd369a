//! Planar convex hull, by gift wrapping: every vertex in turn from the exact comparison of all points around the one
//! before.
//!
//! # Source
//! Jarvis, On the identification of the convex hull of a finite set of points in the plane, 1973. The paper takes the
//! hull for granted ("our input can be assumed to be a convex polygon", Section 4.1).
//!
//! # Method
//! 1. Start at the lexicographically smallest point, its first occurrence.
//! 2. The next vertex is the point that has no other point to the right of the ray towards it; of the points on
//!    that ray the farthest, of equal points the first.
//! 3. Repeat until the start returns.
//!
//! # Complexity
//! n points, h vertices: O(n·h) time, O(h) space.
//!
//! # Numerics
//! All decisions are exact. Vertices are input points, bit for bit.
//!
//! # Checked by
//! This is the truth; the crate `verifier` checks it by the definition.
//!
//! # Example
//! ```
//! let points = [[1.0, 1.0], [0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [0.0, 2.0]];
//! let hull = zonotope::hull::brute_force::convex_hull(&points, &mut ())?;
//! assert_eq!(hull.vertices(), [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use super::error::{HullError, check_count};
use super::polygon::{ConvexHull, PointIndex};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::orientation::{Turn, orientation_counted};
use crate::tally::Tally;

/// The convex hull.
///
/// Orientation tests are counted.
///
/// # Errors
/// See the module.
pub fn convex_hull(points: &[[f64; 2]], tally: &mut impl Tally) -> Result<ConvexHull, HullError> {
    check_count(points.len())?;
    NonFinite::check_list("point", points)?;
    let start = (0..points.len()).fold(0, |best, at| if points[at] < points[best] { at } else { best });
    let (mut vertices, mut indices) = (Vec::new(), Vec::new());
    let mut current = start;
    loop {
        vertices.push(points[current]);
        indices.push(PointIndex::new(current));
        current = successor(points, current, tally);
        if current == start {
            return Ok(ConvexHull::from_parts(vertices, indices));
        }
    }
}

/// The vertex after `current`, which is a vertex; `current` itself if all points are equal to it.
fn successor(points: &[[f64; 2]], current: usize, tally: &mut impl Tally) -> usize {
    let from = points[current];
    let mut best = current;
    for (at, &point) in points.iter().enumerate() {
        if point == from {
            continue;
        }
        let is_better = points[best] == from
            || match orientation_counted(from, points[best], point, tally) {
                Turn::Right => true,
                Turn::Left => false,
                // both on one ray from an extreme point of the set, where lexicographic order is the order along the
                // ray
                Turn::Straight => (points[best] < point) == (from < point) && points[best] != point,
            };
        if is_better {
            best = at;
        }
    }
    best
}
