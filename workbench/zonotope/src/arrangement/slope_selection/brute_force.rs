//! The k-th leftmost vertex of a line arrangement, by sorting the abscissas of all pairs: the truth the methods are
//! held to.
//!
//! # Source
//! The definition.
//!
//! # Method
//! 1. For each pair of lines with normals (a, b) and (d, e) and a e ≠ b d, take the abscissa (b f − c e) / (a e − b d).
//! 2. Sort; take the k-th.
//!
//! # Complexity
//! O(n² log n) rational operations; space O(n²).
//!
//! # Shapes
//! `arrangement`: n lines in any order, duplicates allowed, n up to about 1000; `rank`: from 1 to the number of
//! vertices.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Checked by
//! Hand-worked examples; its simplicity.
//!
//! # Example
//! ```
//! use zonotope::arrangement::LineArrangement;
//! use zonotope::arrangement::slope_selection::brute_force;
//! // The vertical line x = 5 crosses y = 0 and y = x, which cross at x = 0.
//! let rows = [[1.0, 0.0, -5.0], [0.0, 1.0, 0.0], [1.0, -1.0, 0.0]];
//! let arrangement = LineArrangement::from_rows(&rows).unwrap();
//! let x: Vec<f64> = brute_force::vertices(&arrangement).iter().map(|vertex| vertex.x()).collect();
//! assert_eq!(x, [0.0, 5.0, 5.0]);
//! ```

use super::{ArrangementVertex, SlopeSelectionError};
use crate::arrangement::LineIndex;
use crate::arrangement::fraction::Fraction;
use crate::arrangement::lines::LineArrangement;

/// All vertices from left to right.
pub fn vertices(arrangement: &LineArrangement) -> Vec<ArrangementVertex> {
    let indices = 0..arrangement.len() as u32;
    let pairs = indices.flat_map(|second| (0..second).map(move |first| [first, second].map(LineIndex)));
    let mut vertices: Vec<_> = pairs
        .filter_map(|lines| {
            let [first, second] = lines.map(|line| arrangement.exact_line(line));
            let [x, _, w] = first.meet(&second);
            (!w.is_zero()).then(|| ArrangementVertex { lines, x: Fraction::new(x, w) })
        })
        .collect();
    vertices.sort_by_cached_key(ArrangementVertex::exact_x);
    vertices
}

/// The k-th leftmost vertex.
///
/// # Errors
/// When `rank` is 0 or above the number of vertices.
pub fn kth_leftmost_vertex(arrangement: &LineArrangement, rank: u64) -> Result<ArrangementVertex, SlopeSelectionError> {
    let mut vertices = vertices(arrangement);
    let count = vertices.len() as u64;
    match rank.checked_sub(1) {
        Some(rank) if rank < count => Ok(vertices.swap_remove(rank as usize)),
        _ => Err(SlopeSelectionError::Rank { rank, vertices: count }),
    }
}
