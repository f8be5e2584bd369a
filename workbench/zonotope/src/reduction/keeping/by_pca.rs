//! Order reduction, by principal axes: the generators farthest from the axes are kept, a box along the principal axes
//! of the others takes these.
//!
//! # Source
//! Not in the paper: A.-K. Kopetzki, B. Schürmann and M. Althoff, Methods for order reduction of zonotopes, 2017. The
//! principal axes come from Σ v vᵀ, whose eigenvectors are those of a singular value decomposition of the generators.
//!
//! # Method
//! 1. Score each generator by |v|_1 − |v|_∞ and keep the k − D of highest score, as [`by_girard`](super::by_girard).
//! 2. Find the principal axes of the others by Jacobi's rotations.
//! 3. The others go into the box along these axes.
//!
//! # Complexity
//! O(n log n) comparisons and O(n D²) exact operations; O(n) space.
//!
//! # Numerics
//! Scores and axes are rounded and decide only what is kept and how the box lies. The axes are rounded to 26 bits, so
//! that edges along them are vectors of doubles; half-lengths are rounded up to 26 bits, at most 2^-25 too long.
//! Containment is exact. Where doubles have no room for that, below 2^-1000, the box is one along the coordinate axes.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::{Problem, keeping::by_pca::pca}};
//! let body = Zonotope::new([0.0, 0.0], vec![[2.0, 2.0], [1.0, 1.0], [1.0, -1.0]])?;
//! let reduced = pca(&Problem::new(&body, 2)?)?;
//! // the box along the diagonals is the body itself, but for the rounding of the half-lengths
//! let [[a, b], [c, d]] = *reduced.body.generators() else { panic!("two edges") };
//! let area: f64 = a * d - b * c;
//! assert!(area.abs() >= 6.0 && area.abs() < 6.0 + 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::super::answer::{Problem, Reduced, ReductionError};
use super::super::frame_cover::Frame;
use super::order::{by_falling_score, distance_from_axes, scaled, with_kept};
use super::principal_axes::principal_axes;

/// The reduction by principal axes.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if the box leaves the range of doubles.
pub fn pca<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let vectors = scaled(problem.body().generators());
    let scores: Vec<f64> = vectors.iter().map(distance_from_axes).collect();
    let order = by_falling_score(&scores);
    let (kept, others) = order.split_at(problem.count() - D);
    let axes = principal_axes(others.iter().map(|&index| (vectors[index], 1.0)));
    with_kept(problem, kept, Frame::Along(axes))
}
