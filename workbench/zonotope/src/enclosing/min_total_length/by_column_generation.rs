//! Minimum total length zonotope, by adding the directions that the dual zonotope names, to any precision.
//!
//! # Statement
//! Input: points of R^D, at least one, finite; a precision ε in (0, 1). Output: a zonotope in doubles that contains every point exactly, its total
//! length (the sum of the half-lengths of its generators), and a lower bound for all zonotopes around the points, whose ratio is
//! at most 1 + ε unless the search ends before (its rounds, its directions or its pivots run out: ε below 1e-6, some fifty points of the hull in space): the
//! ratio is always proven and told.
//!
//! # Source
//! The problem of Section 4.3, over all directions rather than a net. The dual: vectors λ_j at the points with Σ λ_j = 0 that maximise Σ λ_j · p_j while
//! Σ_j |λ_j · v| ≤ 1 for every unit vector v, that is, while the zonotope Σ [−1, 1] λ_j lies in the unit ball.
//!
//! # Method
//! 1. A coarse net of directions in the affine hull of the points; in a plane also the edges of the best zonogon, found by a search for its centre.
//! 2. The least zonotope along the directions, and its dual solution λ.
//! 3. The vertices of Σ [−1, 1] λ_j: the farthest one, at distance ρ, proves the lower bound Σ λ_j · p_j / ρ; those farther than 1, as unit vectors, are
//!    directions to add. So are those of forces between the best and the last ones, and the sums of neighbouring generators. Again from 2, until the bounds are within ε.
//! 4. Generators rounded; what they miss of any point is added along the axes.
//!
//! # Complexity
//! A round with k directions, m points with a force: O((k + d)²) a pivot, O(m^{d−1} log m) for the vertices, and one facet search for each point. The number of rounds has no
//! useful bound; it is about 10 to 30.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `generators`: half-lengths.
//!
//! # Numerics
//! Containment is exact; `length` is rounded up, `lower_bound` down with all rounding errors of the vertices accounted for. Points nearer to a subspace than
//! a relative 1e-13 are treated as flat.
//!
//! # Errors
//! [`NonFinite`](super::MinLengthError::NonFinite), [`Empty`](super::MinLengthError::Empty) ⇔ the points are not finite, or none; [`BadEpsilon`](super::MinLengthError::BadEpsilon) ⇔ ε not in (0, 1);
//! [`OutOfRange`](super::MinLengthError::OutOfRange) ⇔ a length is no double.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`in_the_plane`](super::in_the_plane) for D = 2; vertices of zonotopes, whose own length is the optimum; the ratio proves itself.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_total_length::min_length_enclosing;
//! // a diamond is a zonotope: two generators of half-length sqrt(1/2)
//! let diamond = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
//! let answer = min_length_enclosing(&diamond, 1e-9)?;
//! assert!((answer.length - 2f64.sqrt()).abs() < 1e-8 && answer.ratio <= 1.0 + 1e-9);
//! # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
//! ```

use super::answer::{MinLengthError, MinLengthZonotope};
use super::by_direction_net::coarse_net;
use super::search::{Plan, search, validate};
use crate::tally::Tally;

/// More rounds than this are not taken.
const MOST_ROUNDS: usize = 120;

/// A zonotope around the points whose total length is within 1 + ε of the least possible.
///
/// # Errors
/// When the points or ε are refused.
pub fn min_length_enclosing<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    min_length_enclosing_counted(points, epsilon, &mut ())
}

/// As [`min_length_enclosing`], counting operations: points read and rounds of the programs over normals.
///
/// # Errors
/// When the points or ε are refused.
pub fn min_length_enclosing_counted<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    tally: &mut impl Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    validate(points, epsilon)?;
    search(points, coarse_net, &Plan { epsilon, rounds: MOST_ROUNDS }, tally)
}
