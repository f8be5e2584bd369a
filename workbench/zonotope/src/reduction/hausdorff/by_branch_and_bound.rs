//! The Hausdorff distance of two zonotopes, by branch and bound over cones of directions.
//!
//! # Statement
//! Input: two zonotopes A, B in R^D and a width ω ≥ 0. Output: bounds of the Hausdorff distance with upper ≤ (1 + ω)
//! lower, and a direction that attains the lower one up to rounding; or the bounds that a `Limit` on the work, or
//! rounding, allows. `excess` bounds the largest distance of a point of A from B, which is 0 just when A lies in B.
//! Bodies without generators, flat bodies, zero and parallel generators are ordinary input.
//!
//! # Source
//! Not in the paper, where Lemma 5.5 bounds H by a constant. Branch and bound over cones, with these bounds.
//!
//! # Method
//! 1. Leave out generators that both bodies have. Begin with the cones of D faces of a cube.
//! 2. In the cone over a box of corners u_i the support function of the farther body lies below the interpolation of
//!    its values at the corners, as it is convex; that of the other lies above a · u for any of its points a, here for
//!    its extreme point in the middle. The difference of these two is linear: its maximum over the unit vectors of the
//!    cone is at most its largest value at a corner of length 1, divided by the least cosine of the corners with the
//!    middle. The gap to the value in the middle falls with the square of the cone's width.
//! 3. No value is above the maximum of a convex function of few terms (`convex_bound`), which is bounded first, in the
//!    same way: it tells distances that are far smaller than what a cone's gap comes to.
//! 4. Cut the cone of the highest bound in two at the middle of its longest side, until no bound exceeds (1 + ω) times
//!    the largest value that was met.
//! 5. Where the bounds are still farther apart, rounding may hide the distance: the difference is taken exactly, along
//!    the best directions of both searches and some that are better (`ascent`).
//!
//! # Complexity
//! N cones in all, each at the cost of the generators that change their sign in it; the first ones look at all. A
//! distance of δ D(A) takes N = O((ω δ)^(−(D − 1)/2)), each with 2^(D − 1) corners; less where the difference is far
//! below its maximum. The limit ends what would take longer than some tenth of a second for n ≤ 1000. O(N) space, and
//! the lists of generators.
//!
//! # Shapes
//! `generators`: half-segments, any order.
//!
//! # Numerics
//! The bounds are those of the exact distance: each holds a bound on the rounding errors of all sums, some k u times
//! the sum of all lengths for k generators of the farther body. The cones cover the directions exactly. Of a distance
//! that is as small as that only the convex function and exact values tell.
//!
//! # Checked by
//! [`brute_force`](super::brute_force).
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::hausdorff::by_branch_and_bound::hausdorff_by_cones};
//! let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?;
//! let diamond = Zonotope::new([0.0, 0.0], vec![[0.5, 0.5], [0.5, -0.5]])?;
//! let distance = hausdorff_by_cones(&square, &diamond, 0.01);
//! // the corner (1, 1) is 1/√2 from the diamond's edge x + y = 1
//! assert!(distance.lower <= 0.5f64.sqrt() && 0.5f64.sqrt() <= distance.upper);
//! assert!(distance.upper <= 1.01 * distance.lower);
//! # Ok::<(), zonotope::ZonotopeError>(())
//! ```

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::answer::Distance;
use super::ascent::climbed;
use super::cone::Cone;
use super::difference::{Difference, Rounding, ScaledBodies, convex_bound};
use super::exact_difference::ExactDifference;
use crate::zonotope::Zonotope;

/// The work after which a search ends with the bounds that it has, whatever the width.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::reduction) struct Limit {
    /// The most cones.
    pub(in crate::reduction) cones: usize,
    /// About the most products of a direction and a vector, beside those of the cones of whole faces.
    pub(in crate::reduction) products: u64,
}

impl Limit {
    /// The limit of an answer: some tenth of a second.
    pub(in crate::reduction) const ANSWER: Self = Self { cones: 1 << 18, products: 1 << 24 };

    /// The limit where only the better one of some bodies is sought.
    pub(in crate::reduction) const COMPARISON: Self = Self { cones: 1 << 12, products: 1 << 20 };

    /// The limit of the convex bound, which most searches do not need.
    const CONVEX: Self = Self { cones: 1 << 10, products: 1 << 21 };

    fn min(self, other: Self) -> Self {
        Self { cones: self.cones.min(other.cones), products: self.products.min(other.products) }
    }
}

/// The Hausdorff distance between bounds whose ratio is at most 1 + `width`, where the limits and rounding allow it.
#[inline(never)]
pub fn hausdorff_by_cones<const D: usize>(a: &Zonotope<D>, b: &Zonotope<D>, width: f64) -> Distance<D> {
    bounded(&ExactDifference::new(a, b), &[0, 1], width, Limit::ANSWER)
}

/// A cone among those that are still to be cut, for one of the differences.
struct Waiting<const D: usize> {
    cone: Cone<D>,
    side: usize,
    /// When it joined, so that the order is a total one.
    turn: usize,
}

impl<const D: usize> PartialEq for Waiting<D> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<const D: usize> Eq for Waiting<D> {}

impl<const D: usize> PartialOrd for Waiting<D> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const D: usize> Ord for Waiting<D> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.cone.upper.total_cmp(&other.cone.upper).then(other.turn.cmp(&self.turn))
    }
}

/// A difference with what bounds it everywhere.
struct Side<const D: usize> {
    difference: Difference<D>,
    rounding: Rounding,
    /// No value exceeds this.
    limit: f64,
}

/// The cones that wait, and the best value met.
struct Search<const D: usize> {
    heap: BinaryHeap<Waiting<D>>,
    turn: usize,
    products: u64,
    width: f64,
    lower: f64,
    direction: [f64; D],
    /// The highest bound of the cones that need not be cut, or cannot be.
    upper: f64,
}

impl<const D: usize> Search<D> {
    /// Bounds of the largest value of any of some differences.
    fn run(sides: &[Side<D>], width: f64, limit: Limit) -> Self {
        let direction = std::array::from_fn(|k| if k == 0 { 1.0 } else { 0.0 });
        let mut search =
            Self { heap: BinaryHeap::new(), turn: 0, products: 0, width, lower: 0.0, direction, upper: 0.0 };
        for (index, side) in sides.iter().enumerate().filter(|(_, side)| !side.difference.is_zero()) {
            let cones = Cone::faces(&side.difference, &side.rounding);
            cones.into_iter().for_each(|cone| search.add(cone, index, side.limit));
        }
        while let Some(Waiting { cone, side: index, .. }) = search.heap.pop() {
            if search.is_settled(&cone) || search.turn >= limit.cones || search.products > limit.products {
                search.upper = search.upper.max(cone.upper);
                break;
            }
            let side = &sides[index];
            search.products += 2 * cone.products();
            match cone.halves(&side.difference, &side.rounding) {
                Some(halves) => halves.into_iter().for_each(|half| search.add(half, index, side.limit)),
                None => search.upper = search.upper.max(cone.upper),
            }
        }
        search
    }

    /// Whether a cone's bound is low enough, or as low as rounding lets it be.
    fn is_settled(&self, cone: &Cone<D>) -> bool {
        cone.upper <= (1.0 + self.width) * self.lower + cone.doubt
    }

    fn add(&mut self, mut cone: Cone<D>, side: usize, limit: f64) {
        cone.upper = cone.upper.min(limit);
        if cone.lower > self.lower {
            (self.lower, self.direction) = (cone.lower, cone.middle);
        }
        if !self.is_settled(&cone) {
            self.heap.push(Waiting { cone, side, turn: self.turn });
            self.turn += 1;
        } else {
            self.upper = self.upper.max(cone.upper);
        }
    }
}

/// The largest value of the difference of the support functions for one side, or for either.
pub(super) fn bounded<const D: usize>(
    exact: &ExactDifference<D>,
    sides: &[usize],
    width: f64,
    limit: Limit,
) -> Distance<D> {
    let bodies = ScaledBodies::new(exact);
    let mut starts = Vec::new();
    let mut convex_upper = 0.0f64;
    let mut bounded = |&side: &usize| {
        let difference = bodies.difference(side);
        let rounding = difference.rounding();
        let left = ScaledBodies::new(&convex_bound(exact, side));
        let convex = left.difference(0);
        let convex = Side { rounding: convex.rounding(), difference: convex, limit: f64::INFINITY };
        let found = Search::run(&[convex], width / 2.0, limit.min(Limit::CONVEX));
        let upper = left.unscaled_above(found.upper);
        convex_upper = convex_upper.max(upper);
        starts.push((side, found.direction));
        Side { difference, rounding, limit: bodies.scaled_above(upper) }
    };
    let searched: Vec<Side<D>> = sides.iter().map(&mut bounded).collect();
    let found = Search::run(&searched, width, limit);
    let upper = bodies.unscaled_above(found.upper).min(convex_upper);
    let (mut lower, mut direction) = (bodies.unscaled_below(found.lower), found.direction);
    if upper > (1.0 + width) * lower {
        starts.extend(sides.iter().map(|&side| (side, found.direction)));
        for (proved, along) in starts.into_iter().filter_map(|(side, start)| climbed(exact, side, start)) {
            if proved > lower {
                (lower, direction) = (proved, along);
            }
        }
    }
    Distance::between(lower.min(upper), upper, direction)
}
