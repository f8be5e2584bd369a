//! Minimum total length zonotope, along the directions of a net.
//!
//! # Statement
//! Input: points of R^D, at least one, finite; a precision ε in (0, 1). Output: a zonotope in doubles that contains every point exactly, whose total length is at
//! most 1 + ε times the least possible, and a proven lower bound. The ratio that it proves is often far better than 1 + ε.
//!
//! # Source
//! Section 4.3, Theorem 4.7 ([`Net::Paper`]): a net of mesh ε/d and the axes. A generator w = |w| u is v |w| plus a rest of length ≤ |w| ε / d that the axes carry, so the
//! ratio is at most 1 + ε. [`Net::Cells`] needs O(ε^{−(d−1)/2}) directions: u lies in the cone of a cell whose corners v_j are within
//! a distance δ of it, u · v_j ≥ 1 − δ²/2, so u = Σ α_j v_j with Σ α_j ≤ 1 / (1 − δ²/2), and [−u, u] lies in the sum of the segments α_j [−v_j, v_j].
//!
//! # Method
//! 1. The affine hull of the points, coordinates of ordinary size; the net in as many dimensions.
//! 2. The least zonotope along a part of the net ([`fixed_directions`](crate::enclosing::fixed_directions)); the directions that its forces load beyond their limit join, until none does.
//! 3. Its forces, and the farthest vertex of their zonotope: the lower bound for all directions.
//! 4. Generators rounded; what they miss of any point is added along the axes.
//!
//! # Complexity
//! d (d/ε)^{d−1} directions and the axes for the paper's net, O(ε^{−(d−1)/2}) for the other; a pass over them and the time of the method for fixed
//! directions, of which there are few, for each of some rounds.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `generators`: half-lengths.
//!
//! # Numerics
//! Containment is exact; `length` is rounded up, `lower_bound` down. Points nearer to a subspace than a relative 1e-13 are treated as flat.
//!
//! # Errors
//! [`NonFinite`](super::MinLengthError::NonFinite), [`Empty`](super::MinLengthError::Empty) ⇔ the points are not finite, or none; [`BadEpsilon`](super::MinLengthError::BadEpsilon) ⇔ ε not in (0, 1);
//! [`TooManyDirections`](super::MinLengthError::TooManyDirections) ⇔ the net has more than 3000; [`OutOfRange`](super::MinLengthError::OutOfRange) ⇔ a length is no double.
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
//! let answer = by_direction_net::least_enclosing(&square, 0.1, Net::Cells)?;
//! assert!(answer.length >= 2.0 && answer.ratio <= 1.1); // the square itself: two half-sides
//! # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
//! ```

use super::along_net::least_along;
use super::answer::{MinLengthError, MinLengthZonotope};
use super::direction_net::{cell_corners, cell_middles};
use super::finish::validate;

/// Which net.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Net {
    /// Theorem 4.7 as it stands: mesh ε/d, and the axes.
    Paper,
    /// The corners of cells of diameter sqrt(2ε / (1 + ε)): enough for the same ratio.
    Cells,
}

/// Nets of more directions are refused.
const MOST: usize = 3000;

/// The least zonotope along a net for the precision ε.
///
/// # Errors
/// When the points or ε are refused, or the net is too large.
pub fn least_enclosing<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    net: Net,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    validate(points, epsilon)?;
    let size = net.size(D, epsilon);
    if size > MOST {
        return Err(MinLengthError::TooManyDirections(size));
    }
    least_along(points, |rank| net.directions(rank, epsilon), epsilon)
}

impl Net {
    /// Cells along a side of a face of the cube in so many dimensions.
    fn cells(self, dimension: usize, epsilon: f64) -> usize {
        let width = (dimension as f64 - 1.0).sqrt();
        let mesh = match self {
            Self::Paper => epsilon / dimension as f64,
            Self::Cells => (2.0 * epsilon / (1.0 + epsilon)).sqrt() / 2.0,
        };
        // One more than the quotient's integer part: the mesh keeps a margin over rounding.
        ((width / mesh).floor() as usize).saturating_add(1)
    }

    /// How many directions the net for a precision has in R^dimension, or a few more: those that several cells share are counted more than once.
    pub fn size(self, dimension: usize, epsilon: f64) -> usize {
        let side = self.cells(dimension, epsilon).saturating_add(usize::from(self == Self::Cells));
        dimension.saturating_mul(side.saturating_pow(dimension as u32 - 1)).saturating_add(dimension)
    }

    /// The directions, in the first `rank` coordinates.
    pub(super) fn directions<const D: usize>(self, rank: usize, epsilon: f64) -> Vec<[f64; D]> {
        match rank {
            1 => self.embedded::<1, D>(epsilon),
            2 => self.embedded::<2, D>(epsilon),
            3 => self.embedded::<3, D>(epsilon),
            _ => self.embedded::<D, D>(epsilon),
        }
    }

    fn embedded<const R: usize, const D: usize>(self, epsilon: f64) -> Vec<[f64; D]> {
        let cells = self.cells(R, epsilon);
        let mut net: Vec<[f64; R]> = match self {
            Self::Paper => cell_middles(cells),
            Self::Cells => cell_corners(cells),
        };
        if self == Self::Paper {
            let axes = (0..R).map(|a| std::array::from_fn(|c| f64::from(u8::from(a == c))));
            for axis in axes {
                if !net.contains(&axis) {
                    net.push(axis);
                }
            }
        }
        net.iter().map(|v| std::array::from_fn(|c| if c < R { v[c] } else { 0.0 })).collect()
    }
}
