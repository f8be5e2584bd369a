//! The distance of two meshes between two bounds, by branch and bound over pairs of nodes.
//!
//! # Statement
//! Input: two placed hierarchies. Output: bounds of their distance, within a thousandth of each other, and a pair of
//! triangles that is as near as the upper one; 0 where they meet, exactly.
//!
//! # Source
//! No part of the paper: the question that is left of an intersection where there is none.
//!
//! # Method
//! 1. Take the nearest pair of children first; leave out a pair of nodes whose gap is at least 1 − [`TOLERANCE`] times
//!    the nearest distance found so far.
//! 2. Of two leaves, bound the distance of each pair of triangles in doubles; where a pair may be the nearest and its
//!    bounds are too far apart, take the exact square of its distance, or find that it meets.
//! 3. The lower bound is the least of all gaps for which pairs were left out and all lower bounds of triangles.
//!
//! # Complexity
//! One test for each pair of nodes that is reached.
//!
//! # Shapes
//! `nearest`: positions of triangles from 0, of the first mesh and of the second.
//!
//! # Numerics
//! Both bounds are proved, rounded down and up; the upper one is infinite where the distance is above all doubles.
//!
//! # Checked by
//! The least distance of all pairs of triangles, exactly.
//!
//! # Example
//! ```
//! use zonotope::bvh::{Aabb, Bvh, Mesh};
//! let a = Mesh::new(vec![[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]], vec![[0, 1, 2]])?;
//! let b = Mesh::new(vec![[1.0, 1.0, 2.0], [1.0, 1.0, 7.0]], vec![[0, 1, 1]])?;
//! let found = Bvh::<Aabb>::build(&a).distance(&Bvh::build(&b));
//! assert!(found.lower <= 2.0 && 2.0 <= found.upper && found.upper < 2.001 * found.lower);
//! # Ok::<(), zonotope::bvh::MeshError>(())
//! ```

use super::question::Question;
use super::traverse::Counts;
use super::volume::BoundingVolume;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::outward::{at_least, at_most};
use crate::numeric::tolerance::DISTANCE_OF_A_FRAME;
use crate::tally::Tally;

/// The share by which a pair must be nearer than the nearest one to be looked at.
pub const TOLERANCE: f64 = 1e-4;

/// The distance of two meshes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshDistance {
    /// They are not nearer than this.
    pub lower: f64,
    /// They are not farther apart than this.
    pub upper: f64,
    /// A pair of triangles that is no farther apart than `upper`.
    pub nearest: [usize; 2],
}

/// Bounds of the distance.
pub(super) fn distance<V: BoundingVolume>(question: &Question<'_, V>, tally: &mut dyn Tally) -> MeshDistance {
    let mut counts = Counts::default();
    let mut best = Best::NONE;
    let mut stack = vec![(question.proven_gap([0, 0]), [0, 0])];
    while let Some((gap, nodes)) = stack.pop() {
        counts.nodes += 1;
        if gap >= best.limit() {
            best.lower = best.lower.min(gap);
            continue;
        }
        let Some(opened) = question.opened(nodes) else {
            leaves(question, nodes, &mut best, &mut counts);
            if best.is_contact() {
                break;
            }
            continue;
        };
        let [first, second] = opened.map(|pair| (question.proven_gap(pair), pair));
        stack.extend(if first.0 <= second.0 { [second, first] } else { [first, second] });
    }
    counts.add_to(tally);
    best.in_world(question)
}

/// The nearest pairs so far, and what is known of all others: bounds in the frame, and of pairs that were looked at
/// exactly bounds in the coordinates in which the meshes were placed. Each of both upper bounds has its own pair: that
/// of the less in the end is told.
struct Best {
    lower: f64,
    upper: f64,
    pair: [usize; 2],
    exact: [f64; 2],
    exact_pair: [usize; 2],
    /// An upper bound of all, in the frame.
    reach: f64,
}

impl Best {
    const NONE: Self = Self {
        lower: f64::INFINITY,
        upper: f64::INFINITY,
        pair: [0; 2],
        exact: [f64::INFINITY; 2],
        exact_pair: [0; 2],
        reach: f64::INFINITY,
    };

    /// The gap from which on a pair need not be looked at.
    fn limit(&self) -> f64 {
        self.reach * (1.0 - TOLERANCE)
    }

    fn is_contact(&self) -> bool {
        self.exact[1] == 0.0
    }

    /// Takes a pair with bounds of its distance in the frame.
    fn take(&mut self, pair: [usize; 2], [lower, upper]: [f64; 2]) {
        self.lower = self.lower.min(lower);
        if upper < self.upper {
            (self.upper, self.pair) = (upper, pair);
            self.reach = self.reach.min(upper);
        }
    }

    /// Takes a pair with the neighbouring doubles of its distance, and an upper bound in the frame.
    fn take_exactly(&mut self, pair: [usize; 2], [below, above]: [f64; 2], reach: f64) {
        self.exact[0] = self.exact[0].min(below);
        if above < self.exact[1] {
            (self.exact[1], self.exact_pair) = (above, pair);
            self.reach = self.reach.min(reach);
        }
    }

    /// The bounds in the coordinates in which the meshes were placed.
    fn in_world<V: BoundingVolume>(self, question: &Question<'_, V>) -> MeshDistance {
        let world = |bound: f64, factor: f64| {
            bound.is_finite().then(|| (&Dyadic::from_f64(bound) * &Dyadic::from_f64(factor)).scaled(question.unit()))
        };
        let lower = world(self.lower, 1.0 - DISTANCE_OF_A_FRAME).map_or(f64::INFINITY, |bound| at_most(&bound));
        let upper = world(self.upper, 1.0 + DISTANCE_OF_A_FRAME).map_or(f64::INFINITY, |bound| at_least(&bound));
        let (upper, pair) = if self.exact[1] <= upper { (self.exact[1], self.exact_pair) } else { (upper, self.pair) };
        // near the largest double the rounding of the frame leads beyond it, where the distance itself may not
        let is_beyond = upper == f64::INFINITY && self.reach.is_finite();
        let (upper, pair) = if is_beyond { (question.exact_bounds(self.pair)[1], self.pair) } else { (upper, pair) };
        let lower = lower.min(self.exact[0]).min(upper).min(f64::MAX);
        MeshDistance { lower, upper, nearest: question.ordered(pair) }
    }
}

/// Looks at the triangles of two leaves.
fn leaves<V: BoundingVolume>(question: &Question<'_, V>, [i, j]: [usize; 2], best: &mut Best, counts: &mut Counts) {
    let [a, b] = question.hierarchies();
    for &row in &a.topology.order[a.topology.nodes[i].range()] {
        let of_row = question.corners(0, row as usize);
        for &column in &b.topology.order[b.topology.nodes[j].range()] {
            counts.triangles += 1;
            let pair = [row as usize, column as usize];
            let of_column = question.corners(1, column as usize);
            let bounds = question.bounds([&of_row, &of_column]);
            if bounds[0] >= bounds[1].min(best.reach) * (1.0 - TOLERANCE) {
                best.take(pair, bounds);
                continue;
            }
            counts.exact += 1;
            let exact = question.exact_bounds(pair);
            best.take_exactly(pair, exact, question.in_frame(exact[1]));
            if best.is_contact() {
                return;
            }
        }
    }
}
