//! Minimum total length zonotope, along the directions of a net.
//!
//! # Statement
//! Input: points of R^D, at least one, finite; a precision ε in (0, 1). Output: a zonotope in doubles that contains
//! every point exactly, whose total length is at most 1 + ε times the least possible, and a proven lower bound. The
//! ratio that it proves is often far better than 1 + ε.
//!
//! # Source
//! Section 4.3, Theorem 4.7 ([`Net::Paper`]): a net of mesh ε/d and the axes. A generator w = |w| u is v |w| plus a
//! rest of length ≤ |w| ε / d that the axes carry, so the ratio is at most 1 + ε. [`Net::Cells`] needs O(ε^{−(d−1)/2})
//! directions: u lies in the cone of a cell whose corners v_j are within a distance δ of it, u · v_j ≥ 1 − δ²/2, so u =
//! Σ α_j v_j with Σ α_j ≤ 1 / (1 − δ²/2), and [−u, u] lies in the sum of the segments α_j [−v_j, v_j].
//!
//! # Method
//! 1. The affine hull of the points, coordinates of ordinary size; the net in as many dimensions.
//! 2. The least zonotope along a part of the net ([`fixed_directions`](crate::enclosing::fixed_directions)); the
//!    directions that its multipliers load beyond their limit join, until none does.
//! 3. Its multipliers, and the farthest vertex of their zonotope: the lower bound for all directions.
//! 4. Generators rounded; what they miss of any point is added along the axes.
//!
//! # Complexity
//! d (d/ε)^{d−1} directions and the axes for the paper's net, O(ε^{−(d−1)/2}) for the other; a pass over them and the
//! time of the method for fixed directions, of which there are few, for each of some rounds.
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
//! [`OutOfRange`](super::MinLengthError::OutOfRange) ⇔ a length is no double.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`in_the_plane`](super::in_the_plane) for D = 2; the ratio proves itself.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_total_length::{Net, by_direction_net};
//! let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
//! let answer = by_direction_net::min_length_by_net(&square, 0.1, Net::Cells)?;
//! assert!(answer.length >= 2.0 && answer.ratio <= 1.1); // the square itself: two half-sides
//! # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
//! ```

mod along_net;

use super::answer::{MinLengthError, MinLengthZonotope};
use super::conclude::validate;
use super::direction_net::Net;
use along_net::least_along;

/// Nets of more directions than this are refused.
const DIRECTION_LIMIT: usize = 3000;

/// The least zonotope along a net for the precision ε.
///
/// # Errors
/// When the points or ε are refused, or the net is too large.
pub fn min_length_by_net<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    net: Net,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    validate(points, epsilon)?;
    let size = net.size(D, epsilon);
    if size > DIRECTION_LIMIT {
        return Err(MinLengthError::TooManyDirections(size));
    }
    least_along(points, |rank| net.directions(rank, epsilon), epsilon)
}
