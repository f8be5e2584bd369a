//! Farthest vertex of each edge of a convex polygon, by rotating calipers: one walk around the polygon for all edges.
//!
//! # Statement
//! Input: a convex hull. Output: for each edge t, from vertex t to vertex t + 1, the vertex s of the largest distance from its line,
//! and whether vertex s + 1 has the same distance; of two such vertices the first in counter-clockwise order. Empty for a
//! point and for a segment.
//!
//! # Source
//! Shamos, Computational geometry (thesis), 1978; the vertex P_s that Section 4.1 of the paper assigns to the edge P_t P_{t+1}.
//! The paper assumes that it is unique; here ties are reported.
//!
//! # Method
//! 1. Walking on from edge t, vertices get higher over it as long as the next edge turns by less than π from edge t: while
//!    the cross product of edge t and that edge is positive.
//! 2. The first edge s for which it is not starts at the farthest vertex, s; if the cross product is zero, vertex s + 1 ties.
//! 3. Edge t + 1 is at a larger angle, so its walk starts where that of edge t ended.
//!
//! # Complexity
//! h edges: at most 3h cross products, O(h) time; 4h bytes, besides the hull.
//!
//! # Shapes
//! One answer an edge, in the order of the edges.
//!
//! # Numerics
//! All decisions are exact.
//!
//! # Errors
//! None.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`brute_force`](super::brute_force).
//!
//! # Example
//! ```
//! use zonotope::hull::{antipodal, convex_hull};
//!
//! // the top edge is parallel to the bottom edge, the other two have one farthest vertex
//! let trapezium = convex_hull(&[[0.0, 0.0], [4.0, 0.0], [3.0, 1.0], [1.0, 1.0]])?;
//! let farthest = antipodal::farthest_vertices(&trapezium);
//! assert_eq!(farthest.iter().map(|s| (s.vertex().get(), s.is_tied())).collect::<Vec<_>>(),
//!     [(2, true), (0, false), (0, true), (1, false)]);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use super::FarthestVertex;
use crate::hull::polygon::ConvexHull;
use crate::numeric::orientation::{Turn, cross_sign_counted};
use crate::tally::Tally;

/// The farthest vertex of each edge.
pub fn farthest_vertices(hull: &ConvexHull) -> Vec<FarthestVertex> {
    farthest_vertices_counted(hull, &mut ())
}

/// [`farthest_vertices`], counting cross products.
pub fn farthest_vertices_counted(hull: &ConvexHull, tally: &mut impl Tally) -> Vec<FarthestVertex> {
    let vertices = hull.vertices();
    let count = hull.edge_count();
    let mut farthest = Vec::with_capacity(count);
    if count == 0 {
        return farthest;
    }
    let following = |at: usize| if at + 1 < count { at + 1 } else { 0 };
    let mut high = 1;
    let (mut high_from, mut high_to) = (vertices[1], vertices[following(1)]);
    for edge in 0..count {
        let (from, to) = (vertices[edge], vertices[following(edge)]);
        let turn = loop {
            let turn = cross_sign_counted(from, to, high_from, high_to, tally);
            if turn != Turn::Left {
                break turn;
            }
            high = following(high);
            (high_from, high_to) = (high_to, vertices[following(high)]);
        };
        farthest.push(FarthestVertex::new(high, turn == Turn::Straight));
    }
    farthest
}
