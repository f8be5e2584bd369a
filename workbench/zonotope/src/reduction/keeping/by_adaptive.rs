//! Order reduction, by an adaptive rule: generators go into a box as long as a bound on the error allows it.
//!
//! # Source
//! Not in the paper: M. Wetzlinger, A. Kulmburg and M. Althoff, Adaptive parameter tuning for reachability analysis of
//! nonlinear systems, 2021, where the order follows from an error and is not given.
//!
//! # Method
//! 1. Sort the generators by |v|_1 − |v|_∞. Those along an axis cost nothing and go into the box.
//! 2. For one generator, its box exceeds its segment by at most 2 |v'|, v' the vector of |v_k| with the largest
//!    coordinate left out: the segment covers that coordinate. So the box of the first m exceeds them by at most
//!    2 |Σ v'|.
//! 3. The error is the bound of the least m that leaves k generators; take the greatest m whose bound is not above it.
//!    So there may be fewer than k generators, at no cost in the bound.
//!
//! # Complexity
//! O(n log n) comparisons and O(n D) exact additions; O(n) space.
//!
//! # Numerics
//! The bound is rounded and decides only how many generators are kept. The box is rounded up to doubles, so containment
//! is exact.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::{Problem, keeping::by_adaptive::adaptive}};
//! let body = Zonotope::new([0.0, 0.0], vec![[8.0, 0.0], [8.0, 8.0], [0.25, 1.0], [0.0, 2.0]])?;
//! // the box of all but (8, 8) exceeds them by at most 1/2
//! let reduced = adaptive(&Problem::new(&body, 3)?)?;
//! assert_eq!(reduced.body.generators(), [[8.0, 8.0], [8.25, 0.0], [0.0, 3.0]]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::super::answer::{Problem, Reduced, ReductionError};
use super::super::frame_cover::Frame;
use super::order::{by_falling_score, distance_from_axes, scaled, with_kept};
use crate::numeric::linear::dot;
use crate::numeric::scaling::largest_magnitude;

/// The reduction to a count of generators.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if the box leaves the range of doubles.
pub fn adaptive<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let vectors = scaled(problem.body().generators());
    let scores: Vec<f64> = vectors.iter().map(distance_from_axes).collect();
    let order = by_falling_score(&scores);
    let bounds = bounds(&order.iter().rev().map(|&index| vectors[index]).collect::<Vec<_>>());
    let least = order.len() - (problem.count() - D);
    // the bounds do not fall
    let boxed = bounds.partition_point(|bound| *bound <= bounds[least]) - 1;
    with_kept(problem, &order[..order.len() - boxed], Frame::Axes)
}

/// Twice |Σ v'| over the first m vectors, for m = 0 … n.
fn bounds<const D: usize>(vectors: &[[f64; D]]) -> Vec<f64> {
    let mut sum = [0.0; D];
    let mut bounds = vec![0.0];
    for v in vectors {
        let magnitudes = v.map(f64::abs);
        let largest = largest_magnitude(&magnitudes);
        let axis = magnitudes.iter().position(|c| *c == largest);
        for (k, (sum, c)) in sum.iter_mut().zip(magnitudes).enumerate() {
            *sum += if Some(k) == axis { 0.0 } else { c };
        }
        bounds.push(2.0 * dot(&sum, &sum).sqrt());
    }
    bounds
}
