//! Farthest vertex of each edge of a convex polygon, by comparing the heights of all vertices over the edge.
//!
//! # Source
//! The vertex P_s that Section 4.1 of the paper assigns to the edge P_t P_{t+1}. The paper assumes that it is unique.
//!
//! # Method
//! 1. Over edge t, vertex p is higher than vertex q if (P_{t+1} − P_t) × (p − q) is positive; keep the highest.
//! 2. Two vertices that are equally high are neighbours; the first is the one that the other follows.
//!
//! # Complexity
//! h edges: O(h²) time, O(h) space.
//!
//! # Numerics
//! All decisions are exact.
//!
//! # Checked by
//! This is the truth, by definition.
//!
//! # Example
//! ```
//! use zonotope::hull::{antipodal, convex_hull};
//!
//! // the top edge is parallel to the bottom edge, the other two have one farthest vertex
//! let trapezium = convex_hull(&[[0.0, 0.0], [4.0, 0.0], [3.0, 1.0], [1.0, 1.0]], &mut ())?;
//! let farthest = antipodal::brute_force::farthest_vertices(&trapezium, &mut ());
//! assert_eq!(farthest.iter().map(|s| (s.vertex().get(), s.is_tied())).collect::<Vec<_>>(),
//!     [(2, true), (0, false), (0, true), (1, false)]);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use super::FarthestVertex;
use crate::hull::polygon::{ConvexHull, VertexIndex};
use crate::numeric::orientation::{Turn, cross_sign_counted};
use crate::tally::Tally;

/// The farthest vertex of each edge.
///
/// Cross products are counted.
pub fn farthest_vertices(hull: &ConvexHull, tally: &mut impl Tally) -> Vec<FarthestVertex> {
    (0..hull.edge_count()).map(|edge| farthest_vertex(hull, VertexIndex::new(edge), tally)).collect()
}

fn farthest_vertex(hull: &ConvexHull, edge: VertexIndex, tally: &mut impl Tally) -> FarthestVertex {
    let [from, to] = hull.edge(edge);
    let mut best = edge;
    let mut is_tied = false;
    for candidate in (0..hull.vertex_count()).map(VertexIndex::new) {
        let (low, high) = (hull.vertex(best), hull.vertex(candidate));
        if candidate == best {
            continue;
        }
        match cross_sign_counted(from, to, low, high, tally) {
            Turn::Left => (best, is_tied) = (candidate, false),
            Turn::Straight => {
                is_tied = true;
                if hull.next(candidate) == best {
                    best = candidate;
                }
            }
            Turn::Right => {}
        }
    }
    FarthestVertex::new(best.get(), is_tied)
}
