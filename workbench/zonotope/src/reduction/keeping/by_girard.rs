//! Order reduction, by Girard's rule: the generators farthest from the axes are kept, a box takes the others.
//!
//! # Source
//! Not in the paper: A. Girard, Reachability of uncertain linear systems using zonotopes, 2005; the rule most used in
//! reachability analysis. It shows what Lemma 5.5 and cluster sums gain.
//!
//! # Method
//! 1. Score each generator by |v|_1 − |v|_∞, 0 along an axis.
//! 2. Keep the k − D of highest score. The others go into the box of half-lengths Σ |v_k|.
//!
//! # Complexity
//! O(n log n) comparisons and O(n D) exact additions; O(n) space.
//!
//! # Numerics
//! Scores are rounded and decide only what is kept. The box is rounded up to doubles, so containment is exact.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::{Problem, keeping::by_girard::girard}};
//! let body = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [3.0, 3.0], [0.5, 0.25], [0.0, 2.0]])?;
//! let reduced = girard(&Problem::new(&body, 3)?)?;
//! // (3, 3) is farthest from the axes, and the box of the others has the half-lengths 3/2 and 9/4
//! assert_eq!(reduced.body.generators(), [[3.0, 3.0], [1.5, 0.0], [0.0, 2.25]]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::super::answer::{Problem, Reduced, ReductionError};
use super::super::frame_cover::Frame;
use super::order::{by_falling_score, distance_from_axes, scaled, with_kept};

/// The reduction by Girard's rule.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if the box leaves the range of doubles.
pub fn girard<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let scores: Vec<f64> = scaled(problem.body().generators()).iter().map(distance_from_axes).collect();
    with_kept(problem, &by_falling_score(&scores)[..problem.count() - D], Frame::Axes)
}
