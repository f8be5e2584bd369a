//! Order reduction, by Combastel's rule: the longest generators are kept, a box takes the others.
//!
//! # Source
//! Not in the paper: C. Combastel, A state bounding observer based on zonotopes, 2003.
//!
//! # Method
//! 1. Score each generator by its Euclidean length.
//! 2. Keep the k − D longest. The others go into the box of half-lengths Σ |v_k|.
//!
//! # Complexity
//! O(n log n) comparisons and O(n D) exact additions; O(n) space.
//!
//! # Numerics
//! Lengths are rounded and decide only what is kept. The box is rounded up to doubles, so containment is exact.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::{Problem, keeping::by_combastel::combastel}};
//! let body = Zonotope::new([0.0, 0.0], vec![[8.0, 0.0], [3.0, 3.0], [0.5, 0.25], [0.0, 2.0]])?;
//! let reduced = combastel(&Problem::new(&body, 3)?)?;
//! // (8, 0) is the longest, and the box of the others has the half-lengths 7/2 and 21/4
//! assert_eq!(reduced.body.generators(), [[8.0, 0.0], [3.5, 0.0], [0.0, 5.25]]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::super::answer::{Problem, Reduced, ReductionError};
use super::super::frame_cover::Frame;
use super::order::{by_falling_score, scaled, with_kept};
use crate::numeric::linear::dot;

/// The reduction by Combastel's rule.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if the box leaves the range of doubles.
pub fn combastel<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let squares: Vec<f64> = scaled(problem.body().generators()).iter().map(|v| dot(v, v)).collect();
    with_kept(problem, &by_falling_score(&squares)[..problem.count() - D], Frame::Axes)
}
