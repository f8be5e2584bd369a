//! Problem: the k-th leftmost vertex of an arrangement of lines.
//!
//! In the dual, lines are points and the k-th vertex is the pair of points with the k-th smallest slope, whence the
//! name.
//!
//! # Statement
//! Input: n lines ([`LineArrangement`]) and a rank k, from 1. Output: a vertex at the k-th smallest abscissa, every
//! pair of lines that is not parallel counted once, also where several pairs cross in one point. A vertical line
//! crosses every line that is not vertical; parallel and equal lines have no vertex; a line whose normal is zero is no
//! line. Where several vertices share the k-th abscissa, any of them may be returned: the answer is the abscissa, which
//! is exact and does not depend on a seed.
//!
//! # Errors
//! [`SlopeSelectionError::Rank`] ⇔ the rank is 0 or above the number of vertices.
//!
//! # Methods
//! | method | cost for n lines | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n² log n), exact rationals | the truth |
//! | [`randomized`] | O(n log n) expected | the default |

pub mod brute_force;
mod inversions;
mod method;
pub mod randomized;
pub(crate) mod slab;

use thiserror::Error;

pub use method::Method;
pub use randomized::{kth_leftmost_vertex, kth_leftmost_vertices};

use super::fraction::Fraction;
use super::lines::LineArrangement;
use crate::arrangement::LineIndex;
use crate::numeric::Rational;

/// A vertex of an arrangement: where two lines cross.
#[derive(Debug, Clone)]
pub struct ArrangementVertex {
    /// Two lines that cross there, the lower index first.
    pub lines: [LineIndex; 2],
    x: Fraction,
}

/// Why there is no k-th leftmost vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SlopeSelectionError {
    /// The rank is 0 or above the number of vertices.
    #[error("there is no vertex of rank {rank} among {vertices}, counted from 1")]
    Rank {
        /// The rank.
        rank: u64,
        /// How many vertices there are.
        vertices: u64,
    },
}

impl ArrangementVertex {
    /// The abscissa, exactly.
    pub fn exact_x(&self) -> Rational {
        self.x.to_rational()
    }

    /// The abscissa within a relative 2^-50; infinite where it leaves the range of doubles.
    pub fn x(&self) -> f64 {
        self.x.to_f64()
    }
}

fn zero_based(arrangement: &LineArrangement, rank: u64) -> Result<u64, SlopeSelectionError> {
    let vertices = arrangement.vertex_count();
    rank.checked_sub(1).filter(|&rank| rank < vertices).ok_or(SlopeSelectionError::Rank { rank, vertices })
}

#[cfg(test)]
mod tests;
