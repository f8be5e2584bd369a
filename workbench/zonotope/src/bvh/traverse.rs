//! Pairs of triangles that meet, by descending pairs of nodes: one traversal for all volumes and all questions of
//! intersection.
//!
//! # Statement
//! Input: two placed hierarchies. Output: every pair of triangles with a common point, each once, until the caller
//! stops; closed, so touching counts.
//!
//! # Source
//! Section 1 of the paper names the use: bounding volumes in hierarchies of varying complexity.
//!
//! # Method
//! 1. Take a pair of nodes from the stack; if their volumes are proved disjoint, it is done.
//! 2. Of two leaves, test every pair of triangles: by the planes of both in doubles, with bounded
//!    doubles where no plane separates them, and exactly where these leave a doubt.
//! 3. Else open the larger node, or the one that is no leaf.
//!
//! # Complexity
//! One test for each pair of nodes that is reached; of meshes of m and n triangles O(m n) at worst.
//!
//! # Shapes
//! Pairs are positions of triangles from 0, of the first mesh and of the second.
//!
//! # Numerics
//! A pair of nodes is left out only if a gap above all rounding proves it; pairs of triangles are decided exactly.
//!
//! # Checked by
//! [`brute_force`](super::brute_force).
//!
//! # Example
//! ```
//! use zonotope::bvh::{Bvh, Dop18, Mesh};
//! let strip = |x: f64| {
//!     let vertices = (0..4).map(|i| [x + f64::from(i / 2), f64::from(i % 2), 0.0]).collect();
//!     Mesh::new(vertices, vec![[0, 1, 2], [1, 2, 3]])
//! };
//! let [a, b] = [Bvh::<Dop18>::build(&strip(0.0)?), Bvh::build(&strip(1.0)?)];
//! assert_eq!(a.pairs(&b), [[0, 0], [1, 0], [1, 1]]); // along x = 1
//! # Ok::<(), zonotope::bvh::MeshError>(())
//! ```

use std::ops::ControlFlow;

use super::question::Question;
use super::volume::BoundingVolume;
use crate::tally::{Operation, Tally};

/// Room for pairs of nodes from the start: a pair that is opened leaves one more, and trees are seldom deeper than this
/// together.
const STACK: usize = 64;

/// Calls `visit` with every pair of triangles that meet, until it breaks.
pub(super) fn descend<V: BoundingVolume>(
    question: &Question<'_, V>,
    tally: &mut dyn Tally,
    mut visit: impl FnMut([usize; 2]) -> ControlFlow<()>,
) {
    let [a, b] = question.hierarchies();
    let mut stack = Vec::with_capacity(STACK);
    stack.push([0, 0]);
    let mut counts = Counts::default();
    let mut corners = Vec::new();
    while let Some([i, j]) = stack.pop() {
        counts.nodes += 1;
        if question.are_apart([i, j]) {
            continue;
        }
        if let Some([first, second]) = question.opened([i, j]) {
            stack.extend([second, first]);
            continue;
        }
        let (rows, columns) = (&a.topology.nodes[i], &b.topology.nodes[j]);
        corners.clear();
        let columns = &b.topology.order[columns.range()];
        corners.extend(columns.iter().map(|&t| question.corners(1, t as usize).with_plane()));
        let is_stopped = a.topology.order[rows.range()].iter().any(|&row| {
            let of_row = question.corners(0, row as usize).with_plane();
            columns.iter().zip(&corners).any(|(&column, of_column)| {
                counts.triangles += 1;
                let pair = [row as usize, column as usize];
                question.meet(pair, [&of_row, of_column], &mut counts.exact) && visit(question.ordered(pair)).is_break()
            })
        });
        if is_stopped {
            break;
        }
    }
    counts.add_to(tally);
}

/// Tests of a descent.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Counts {
    pub(super) nodes: u64,
    pub(super) triangles: u64,
    pub(super) exact: u64,
}

impl Counts {
    pub(super) fn add_to(self, tally: &mut dyn Tally) {
        tally.add(Operation::NodeTest, self.nodes);
        tally.add(Operation::TriangleTest, self.triangles);
        tally.add(Operation::ExactFallback, self.exact);
    }
}
