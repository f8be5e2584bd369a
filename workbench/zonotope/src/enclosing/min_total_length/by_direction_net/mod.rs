//! Minimum total length zonotope, along the directions of a net.
//!
//! # Statement
//! Input: points of R^D, at least one, finite; a precision ε in (0, 1). Output: a zonotope in doubles that contains
//! every point exactly, whose total length is at most 1 + ε times the least possible unless the work ends before, and a
//! proven lower bound. The ratio that it proves is often far better than 1 + ε.
//!
//! # Source
//! Section 4.3, Theorem 4.7 ([`Net::Paper`]): a net of mesh ε/d and the axes. Some direction v of the net differs from
//! the direction u of a generator w by at most ε/d, so w is |w| v and a rest of length at most |w| ε/d. The axes carry
//! the rest, and the ratio is at most 1 + ε. [`Net::Cells`] needs only O(ε^{−(d−1)/2}) directions. There u lies in the
//! cone of a cell, and every corner v_j of the cell is within some δ of u, so that u · v_j ≥ 1 − δ²/2. Hence u = Σ α_j
//! v_j with α_j ≥ 0 and Σ α_j ≤ 1 / (1 − δ²/2), and the segment [−u, u] lies in the sum of the segments α_j [−v_j,
//! v_j].
//!
//! # Method
//! 1. Take coordinates of ordinary size in the affine hull of the points, and the net for its dimension.
//! 2. Solve the linear program along a part of the net ([`fixed_directions`](crate::enclosing::fixed_directions)). Add
//!    directions whose dual constraints the multipliers violate, and repeat until there are none.
//! 3. Divide the multipliers by the distance of the farthest vertex of Σ [−1, 1] λ_j: the lower bound for all
//!    directions.
//! 4. Round the generators, and add along the axes the most that they miss of any point.
//!
//! # Complexity
//! d (d/ε)^{d−1} directions and the axes for the paper's net, O(ε^{−(d−1)/2}) for the other. Each of some rounds takes
//! a pass over the directions and the time of the method for fixed directions with the part of them that has joined.
//! Along the other net the work ends after 2^31 entries of the programs and products of points, about a second, with
//! the shortest zonotope and the greatest lower bound so far: the ratio that these prove is stated, and
//! [`Outcome`](super::Outcome) says whether it is at most 1 + ε.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `generators`: half-lengths.
//!
//! # Numerics
//! Containment is exact; `length` is rounded up, `lower_bound` down. Points nearer to a subspace than a relative 1e-13
//! are treated as flat.
//!
//! # Errors
//! [`NonFinite`](super::MinLengthError::NonFinite), [`Empty`](super::MinLengthError::Empty) ⇔ the points are not
//! finite, or none; [`BadEpsilon`](super::MinLengthError::BadEpsilon) ⇔ ε not in (0, 1);
//! [`TooManyDirections`](super::MinLengthError::TooManyDirections) ⇔ the net has more than 3000;
//! [`OutOfRange`](super::MinLengthError::OutOfRange) ⇔ a length exceeds the largest double.
//!
//! # Checked by
//! [`in_the_plane`](super::in_the_plane) for D = 2; in any dimension the crate `verifier` checks the proof of the
//! ratio.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_total_length::{Net, by_direction_net};
//! let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
//! let answer = by_direction_net::min_length_by_net(&square, 0.1, Net::Cells, &mut ())?;
//! assert!(answer.value >= 2.0 && answer.ratio() <= 1.1); // the square itself: two half-sides
//! # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
//! ```

mod along_net;

use super::answer::{MinLengthError, MinLengthZonotope};
use super::conclude::validate;
use crate::enclosing::min_total_length::direction_net::Net;
use crate::tally::Tally;
use along_net::min_length_along_net;

/// Nets of more directions than this are refused.
const DIRECTION_LIMIT: usize = 3000;

/// The shortest zonotope along a net for the precision ε, whose length is within 1 + ε of the least over all
/// directions.
///
/// Counted is what the linear programs read of points and of matrices, and the directions that are looked at to find
/// those that are missing, once for each multiplier.
///
/// # Errors
/// When the points or ε are refused, or the net is too large.
#[inline(never)]
pub fn min_length_by_net<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    net: Net,
    tally: &mut dyn Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    validate(points, epsilon)?;
    let size = net.size(D, epsilon);
    if size > DIRECTION_LIMIT {
        return Err(MinLengthError::TooManyDirections(size));
    }
    min_length_along_net(points, net, epsilon, tally)
}
