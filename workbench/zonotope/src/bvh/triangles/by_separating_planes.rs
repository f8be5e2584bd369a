//! Whether two triangles meet, by all directions along which they could be apart, in exact numbers.
//!
//! # Statement
//! Input: two triangles with exact corners, in any position. Output: whether they have a point in common, closed.
//!
//! # Source
//! No part of the paper: convex sets are disjoint just when a plane separates them, and of two polytopes one parallel
//! to a facet of their difference.
//!
//! # Method
//! The difference of both triangles is a polytope P whose faces are differences of faces. If the origin is outside, a
//! direction separates it, by the dimension of P:
//! 1. space: the normal of a facet, orthogonal to two edges of the triangles;
//! 2. a plane: its normal, orthogonal to two edges, if the origin is off it; else the normal of an edge in it;
//! 3. a line: the part of the displacement across it, if the origin is off it; else its direction;
//! 4. a point: the displacement.
//!
//! All of these are tried, whatever the dimension is: a direction that separates does so in any.
//!
//! # Complexity
//! O(1): at most 15 + 6 + 6 + 2 directions with six products each.
//!
//! # Shapes
//! `a`, `b`: three corners, in any order, equal ones allowed.
//!
//! # Numerics
//! Exact throughout.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), on small whole coordinates with all special positions.
//!
//! # Example
//! ```
//! use zonotope::bvh::{Mesh, meet};
//! let square = |x: f64| Mesh::new(vec![[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0]], vec![[0, 1, 2]]);
//! assert!(meet(&square(0.0)?, &square(1.0)?)); // in one plane, they touch in a corner
//! assert!(!meet(&square(0.0)?, &square(1.0f64.next_up())?));
//! # Ok::<(), zonotope::bvh::MeshError>(())
//! ```

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, is_zero};

/// Whether two triangles meet.
pub(crate) fn meet(a: &[ExactVector; 3], b: &[ExactVector; 3]) -> bool {
    let sides = |t: &[ExactVector; 3]| [difference(&t[1], &t[0]), difference(&t[2], &t[1]), difference(&t[0], &t[2])];
    let edges: Vec<ExactVector> = sides(a).into_iter().chain(sides(b)).filter(|edge| !is_zero(edge)).collect();
    let is_separated = |u: &ExactVector| separates(u, a, b);
    let mut plane = None;
    for (k, second) in edges.iter().enumerate() {
        for first in &edges[..k] {
            let normal = cross(first, second);
            if is_zero(&normal) {
                continue;
            }
            if is_separated(&normal) {
                return false;
            }
            plane.get_or_insert(normal);
        }
    }
    let displacement = difference(&b[0], &a[0]);
    let in_plane = plane.iter().flat_map(|normal| edges.iter().map(move |edge| cross(normal, edge)));
    let across = edges.first().map(|edge| cross(edge, &cross(&displacement, edge)));
    !in_plane.chain(edges.iter().cloned()).chain(across).chain([displacement]).any(|u| is_separated(&u))
}

/// Whether the triangles have different heights along a direction.
fn separates(u: &ExactVector, a: &[ExactVector; 3], b: &[ExactVector; 3]) -> bool {
    let extent = |triangle: &[ExactVector; 3]| -> [Dyadic; 2] {
        let [p, q, r] = triangle.each_ref().map(|corner| dot(u, corner));
        let (low, high) = if p < q { (p, q) } else { (q, p) };
        if r < low {
            [r, high]
        } else if high < r {
            [low, r]
        } else {
            [low, high]
        }
    };
    let ([low_a, high_a], [low_b, high_b]) = (extent(a), extent(b));
    high_a < low_b || high_b < low_a
}
