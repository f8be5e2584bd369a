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
//! 4. The edges are cut into ranges. The first vertex of each is found by binary search, and four ranges are walked in turn: the
//!    steps of one walk depend on each other, those of several keep the processor busy.
//!
//! # Complexity
//! h edges: O(h) time. At most 2h cross products in the walks, and log h + 1 in each of at most max(33, h/1024 + 1) binary searches.
//! 4h bytes, besides the hull.
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

use std::array;
use std::ops::Range;

use super::FarthestVertex;
use crate::hull::polygon::{ConvexHull, VertexIndex};
use crate::numeric::orientation::{Turn, cross_sign_counted};
use crate::tally::Tally;

/// The farthest vertex of each edge.
pub fn farthest_vertices(hull: &ConvexHull) -> Vec<FarthestVertex> {
    farthest_vertices_counted(hull, &mut ())
}

/// [`farthest_vertices`], counting cross products.
pub fn farthest_vertices_counted(hull: &ConvexHull, tally: &mut impl Tally) -> Vec<FarthestVertex> {
    let count = hull.edge_count();
    let mut farthest = vec![FarthestVertex::new(0, false); count];
    let length = (count / 32).clamp(64, 1024);
    let mut walks = (0..count).step_by(length).map(|edge| edge..(edge + length).min(count));
    let mut lanes: [Walk; LANES] = array::from_fn(|_| Walk::start(hull, walks.next().unwrap_or(0..0), tally));
    let mut are_under_way = lanes.iter().all(Walk::is_under_way);
    while are_under_way {
        for lane in &mut lanes {
            lane.step(hull.vertices(), &mut farthest, tally);
            if !lane.is_under_way() {
                match walks.next() {
                    Some(edges) => *lane = Walk::start(hull, edges, tally),
                    None => are_under_way = false,
                }
            }
        }
    }
    for lane in &mut lanes {
        while lane.is_under_way() {
            lane.step(hull.vertices(), &mut farthest, tally);
        }
    }
    farthest
}

/// Walks taken in turn, so that the processor works on several cross products at a time.
const LANES: usize = 4;

/// The walk for a range of edges.
struct Walk {
    /// The edge in question, and the end of the range.
    edge: usize,
    end: usize,
    /// No vertex before it, going back to the edge, is farthest from the edge.
    high: usize,
}

impl Walk {
    /// Finds the farthest vertex of the first edge by binary search: the cross products of an edge with the edges after it are
    /// positive up to that vertex and not positive from there on.
    fn start(hull: &ConvexHull, edges: Range<usize>, tally: &mut impl Tally) -> Self {
        let count = hull.edge_count();
        let wrapped = |at: usize| if at < count { at } else { at - count };
        let (mut before, mut after) = (edges.start, edges.start + count);
        while !edges.is_empty() && after - before > 1 {
            let between = before.midpoint(after);
            let [from, to] = hull.edge(VertexIndex::new(edges.start));
            let [high_from, high_to] = hull.edge(VertexIndex::new(wrapped(between)));
            match cross_sign_counted(from, to, high_from, high_to, tally) {
                Turn::Left => before = between,
                Turn::Straight | Turn::Right => after = between,
            }
        }
        Walk { edge: edges.start, end: edges.end, high: wrapped(after) }
    }

    #[inline(always)]
    fn is_under_way(&self) -> bool {
        self.edge < self.end
    }

    /// Moves on by one edge or by one vertex, without a branch on which: that is as good as random.
    #[inline(always)]
    fn step(&mut self, vertices: &[[f64; 2]], farthest: &mut [FarthestVertex], tally: &mut impl Tally) {
        let following = |at: usize| if at + 1 < vertices.len() { at + 1 } else { 0 };
        let after_high = following(self.high);
        let (from, to) = (vertices[self.edge], vertices[following(self.edge)]);
        let turn = cross_sign_counted(from, to, vertices[self.high], vertices[after_high], tally);
        // final only if the edge moves on, else a later step overwrites it
        farthest[self.edge] = FarthestVertex::new(self.high, turn == Turn::Straight);
        let is_rising = turn == Turn::Left;
        self.high = if is_rising { after_high } else { self.high };
        self.edge += usize::from(!is_rising);
    }
}
