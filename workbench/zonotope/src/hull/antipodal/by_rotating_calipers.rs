//! Farthest vertex of each edge of a convex polygon, by rotating calipers: half a turn of the calipers for all edges.
//!
//! # Source
//! Shamos, Computational geometry (thesis), 1978; the vertex P_s that Section 4.1 of the paper assigns to the edge P_t
//! P_{t+1}. The paper assumes that it is unique; here ties are reported.
//!
//! # Method
//! 1. The edges from edge 0 on that turn by less than π from it are the lower chain, the others the upper chain: both
//!    are sorted by their angle modulo π.
//! 2. Merge the two. Where edge a of the lower and edge b of the upper chain come next, the sign of their cross product
//!    tells which has the smaller angle modulo π: its farthest vertex is the start of the other. If they are parallel,
//!    each ties at the other.
//! 3. The lower chain is cut into ranges. The partner of the first edge of each is found by binary search, and four
//!    ranges are merged in turn: the steps of one merge depend on each other, those of several keep the processor busy.
//!
//! # Complexity
//! h edges: O(h) time. At most h cross products in the merges, and log h + 1 in each of at most max(34, h/1024 + 2)
//! binary searches. 4h bytes, besides the hull.
//!
//! # Numerics
//! All decisions are exact.
//!
//! # Checked by
//! [`brute_force`](super::brute_force).
//!
//! # Example
//! ```
//! use zonotope::hull::{antipodal, convex_hull};
//!
//! // the top edge is parallel to the bottom edge, the other two have one farthest vertex
//! let trapezium = convex_hull(&[[0.0, 0.0], [4.0, 0.0], [3.0, 1.0], [1.0, 1.0]], &mut ())?;
//! let farthest = antipodal::farthest_vertices(&trapezium, &mut ());
//! assert_eq!(farthest.iter().map(|s| (s.vertex().get(), s.is_tied())).collect::<Vec<_>>(),
//!     [(2, true), (0, false), (0, true), (1, false)]);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use std::array;

use super::FarthestVertex;
use crate::hull::polygon::{ConvexHull, VertexIndex};
use crate::numeric::orientation::{Turn, cross_sign_counted};
use crate::tally::Tally;

/// The farthest vertex of each edge.
///
/// Cross products are counted.
pub fn farthest_vertices(hull: &ConvexHull, tally: &mut impl Tally) -> Vec<FarthestVertex> {
    let mut farthest = vec![FarthestVertex::new(0, false); hull.edge_count()];
    let mut merges = merges(hull, tally).into_iter();
    let mut lanes: [Merge; LANES] = array::from_fn(|_| merges.next().unwrap_or_default());
    let mut are_under_way = lanes.iter().all(Merge::is_under_way);
    while are_under_way {
        for lane in &mut lanes {
            lane.step(hull.vertices(), &mut farthest, tally);
            if !lane.is_under_way() {
                match merges.next() {
                    Some(merge) => *lane = merge,
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

/// Merges taken in turn, so that the processor works on several cross products at a time.
const LANES: usize = 4;

/// A range of edges of the lower chain, and the edges of the upper chain that come between them by their angle modulo
/// π.
#[derive(Clone, Copy, Default)]
struct Merge {
    /// The edge of the lower chain that comes next, and where its range ends.
    lower: usize,
    lower_end: usize,
    /// The same in the upper chain. What ends a range is compared as well: it never comes before an edge in the range
    /// of the other chain.
    upper: usize,
    upper_end: usize,
}

/// The merges of all edges, about equally many of the lower chain in each.
fn merges(hull: &ConvexHull, tally: &mut impl Tally) -> Vec<Merge> {
    let count = hull.edge_count();
    if count == 0 {
        return Vec::new();
    }
    let turning = partner(hull, 0, 0, tally);
    let length = (turning / 32).clamp(64, 1024);
    let mut upper = turning;
    let merge = |lower: usize| {
        let lower_end = (lower + length).min(turning);
        let upper_end = if lower_end < turning { partner(hull, lower_end, upper - 1, tally) } else { count };
        Merge { lower, lower_end, upper: std::mem::replace(&mut upper, upper_end), upper_end }
    };
    (0..turning).step_by(length).map(merge).collect()
}

/// The first edge after `before` that turns by π or more from an edge; as the edges after this one do from there on, by
/// binary search.
fn partner(hull: &ConvexHull, edge: usize, mut before: usize, tally: &mut impl Tally) -> usize {
    let [from, to] = hull.edge(VertexIndex::new(edge));
    let mut after = hull.edge_count();
    while after - before > 1 {
        let between = before.midpoint(after);
        let [high_from, high_to] = hull.edge(VertexIndex::new(between));
        match cross_sign_counted(from, to, high_from, high_to, tally) {
            Turn::Left => before = between,
            Turn::Straight | Turn::Right => after = between,
        }
    }
    after
}

impl Merge {
    #[inline(always)]
    fn is_under_way(&self) -> bool {
        self.lower < self.lower_end || self.upper < self.upper_end
    }

    /// Takes an edge of one chain, without a branch on which, that is as good as random; or two parallel edges.
    #[inline(always)]
    fn step(&mut self, vertices: &[[f64; 2]], farthest: &mut [FarthestVertex], tally: &mut impl Tally) {
        let wrapped = |at: usize| if at < vertices.len() { at } else { 0 };
        let (lower, upper) = (self.lower, wrapped(self.upper));
        let (lower_to, upper_to) = (vertices[lower + 1], vertices[wrapped(upper + 1)]);
        let turn = cross_sign_counted(vertices[lower], lower_to, vertices[upper], upper_to, tally);
        if turn == Turn::Straight {
            farthest[lower] = FarthestVertex::new(upper, true);
            farthest[upper] = FarthestVertex::new(lower, true);
            (self.lower, self.upper) = (self.lower + 1, self.upper + 1);
            return;
        }
        let is_upper = turn == Turn::Left;
        let (edge, far) = if is_upper { (upper, lower) } else { (lower, upper) };
        farthest[edge] = FarthestVertex::new(far, false);
        self.upper += usize::from(is_upper);
        self.lower += usize::from(!is_upper);
    }
}
