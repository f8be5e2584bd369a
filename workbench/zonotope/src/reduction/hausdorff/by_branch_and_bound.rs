//! The Hausdorff distance of two zonotopes, by branch and bound over cones of directions.
//!
//! # Statement
//! Input: two zonotopes A, B in R^D and a width ω ≥ 0. Output: bounds of the Hausdorff distance with upper ≤
//! (1 + ω) lower, and a direction that attains the lower one up to rounding; or the bounds that [`CONE_LIMIT`] cones,
//! some 2^31 readings of generators, or rounding allow. [`excess`] bounds the largest distance of a point of A from B,
//! which is 0 just when A lies in B. Bodies without generators, flat bodies, zero and parallel generators are ordinary
//! input.
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
//! 3. No value is above the maximum of a convex function of few terms (`difference`), which
//!    is bounded first, in the same way: it tells distances that are far smaller than what a cone's gap comes to.
//! 4. Cut the cone of the highest bound in two at the middle of its longest side, until no bound exceeds (1 + ω) times
//!    the largest value that was met.
//!
//! # Complexity
//! N cones in all, each at the cost of the generators that change their sign in it; the first ones look at all. A
//! distance of δ D(A) takes N = O((ω δ)^(−(D − 1)/2)), each with 2^(D − 1) corners; less where the difference is far
//! below its maximum. Measured for ω = 1 % in space, n = 10^4 and k = 64: in some 0.1 s; for
//! ω = 10 % in R^6, n = 1000 and k = 32: in about 0.6 s. O(N) space, and the lists of generators.
//!
//! # Shapes
//! `generators`: half-segments, any order.
//!
//! # Numerics
//! The bounds are those of the exact distance: each holds a bound on the rounding errors of all sums, some k u times
//! the sum of all lengths for k generators of the farther body. The cones cover the directions exactly. A distance that
//! is as small as that is not told from 0.
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
//! use zonotope::{Zonotope, reduction::hausdorff::hausdorff};
//! let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?;
//! let diamond = Zonotope::new([0.0, 0.0], vec![[0.5, 0.5], [0.5, -0.5]])?;
//! let distance = hausdorff(&square, &diamond, 0.01);
//! // the corner (1, 1) is 1/√2 from the diamond's edge x + y = 1
//! assert!(distance.lower <= 0.5f64.sqrt() && 0.5f64.sqrt() <= distance.upper);
//! assert!(distance.upper <= 1.01 * distance.lower);
//! # Ok::<(), zonotope::ZonotopeError>(())
//! ```

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::cone::Cone;
use super::difference::{Difference, Rounding, ScaledBodies};
use crate::zonotope::Zonotope;

/// At most this many cones are looked at.
pub const CONE_LIMIT: usize = 1 << 20;

/// About this many times a generator is read at most, besides the first readings of all.
const READ_LIMIT: u64 = 1 << 31;

/// At most this many cones are looked at for the convex bound.
const CONVEX_CONE_LIMIT: usize = 1 << 10;

/// A distance between two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance<const D: usize> {
    /// The distance is not below this.
    pub lower: f64,
    /// The distance is not above this.
    pub upper: f64,
    /// A direction of length about 1 in which the support functions differ by `lower`, up to rounding.
    pub direction: [f64; D],
}

/// The Hausdorff distance between bounds whose ratio is at most 1 + `width`, where [`CONE_LIMIT`] and rounding allow
/// it.
#[inline(never)]
pub fn hausdorff<const D: usize>(a: &Zonotope<D>, b: &Zonotope<D>, width: f64) -> Distance<D> {
    let bodies = ScaledBodies::new(a, b);
    search(&bodies, vec![bodies.difference(0), bodies.difference(1)], width, CONE_LIMIT)
}

/// The largest distance of a point of `body` from `other`, between bounds whose ratio is at most 1 + `width`, where
/// [`CONE_LIMIT`] and rounding allow it.
#[inline(never)]
pub fn excess<const D: usize>(body: &Zonotope<D>, other: &Zonotope<D>, width: f64) -> Distance<D> {
    excess_with_limit(body, other, width, CONE_LIMIT)
}

/// The same with a limit of its own on the number of cones.
pub(in crate::reduction) fn excess_with_limit<const D: usize>(
    body: &Zonotope<D>,
    other: &Zonotope<D>,
    width: f64,
    limit: usize,
) -> Distance<D> {
    let bodies = ScaledBodies::new(body, other);
    search(&bodies, vec![bodies.difference(0)], width, limit)
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
    reads: u64,
    width: f64,
    lower: f64,
    direction: [f64; D],
    /// The highest bound of the cones that need not be cut, or cannot be.
    upper: f64,
}

impl<const D: usize> Search<D> {
    /// Bounds of the largest value of any of some differences, by at most `limit` cones.
    fn run(sides: &[Side<D>], width: f64, limit: usize) -> Self {
        let direction = std::array::from_fn(|k| if k == 0 { 1.0 } else { 0.0 });
        let mut search = Self { heap: BinaryHeap::new(), turn: 0, reads: 0, width, lower: 0.0, direction, upper: 0.0 };
        for (index, side) in sides.iter().enumerate().filter(|(_, side)| !side.difference.is_zero()) {
            let cones = Cone::faces(&side.difference, &side.rounding);
            cones.into_iter().for_each(|cone| search.add(cone, index, side.limit));
        }
        while let Some(Waiting { cone, side: index, .. }) = search.heap.pop() {
            if search.is_settled(&cone) || search.turn >= limit || search.reads > READ_LIMIT {
                search.upper = search.upper.max(cone.upper);
                break;
            }
            let side = &sides[index];
            search.reads += 2 * cone.reads();
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

fn search<const D: usize>(
    bodies: &ScaledBodies<D>,
    differences: Vec<Difference<D>>,
    width: f64,
    limit: usize,
) -> Distance<D> {
    let bounded = |difference: Difference<D>| {
        let rounding = difference.rounding();
        let convex = Side { difference: difference.convex_bound(), rounding, limit: f64::INFINITY };
        let limit = Search::run(&[convex], width / 2.0, limit.min(CONVEX_CONE_LIMIT)).upper;
        Side { difference, rounding, limit }
    };
    let sides: Vec<Side<D>> = differences.into_iter().map(bounded).collect();
    let found = Search::run(&sides, width, limit);
    Distance {
        lower: bodies.unscaled_below(found.lower),
        upper: bodies.unscaled_above(found.upper),
        direction: found.direction,
    }
}
