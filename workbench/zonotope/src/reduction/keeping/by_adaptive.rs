//! Order reduction, by an adaptive rule: generators go into a box as long as a bound on the error allows it.
//!
//! # Statement
//! Input: a zonotope in R^D and ε in (0, 1), or a count k ≥ D. Output: a zonotope with the same centre that contains it
//! exactly, with a proof by [`Shares`](super::super::Shares). For ε the Hausdorff distance is at most ε times the
//! diagonal of the body's bounding box, up to rounding. For a count there are at most k generators, and fewer where the
//! bound allows it at no cost. Flat bodies, zero and parallel generators are ordinary input.
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
//! 3. Take the greatest m for which that is at most ε times the diagonal; for a count, the greatest m whose bound is
//!    not above that of the least m that leaves k generators.
//!
//! # Complexity
//! O(n log n) comparisons and O(n D) exact additions; O(n) space.
//!
//! # Shapes
//! `generators`: n × D, half-segments, any order.
//!
//! # Numerics
//! The bound is rounded and decides only how many generators are kept. The box is rounded up to doubles, so containment
//! is exact.
//!
//! # Errors
//! [`BadEpsilon`](super::super::ReductionError::BadEpsilon) ⇔ ε is not in (0, 1);
//! [`OutOfRange`](super::super::ReductionError::OutOfRange) ⇔ a side of the box exceeds the largest double.
//!
//! # Checked by
//! [`brute_force`](super::super::brute_force) and the check of the shares, in rationals.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::keeping::by_adaptive::adaptive_within};
//! let body = Zonotope::new([0.0, 0.0], vec![[8.0, 0.0], [8.0, 8.0], [0.25, 1.0], [0.0, 2.0]])?;
//! // the diagonal is 39.2 long; the box of all but (8, 8) exceeds them by at most 1/2
//! let reduced = adaptive_within(&body, 0.02)?;
//! assert_eq!(reduced.body.generators(), [[8.0, 8.0], [8.25, 0.0], [0.0, 3.0]]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::super::answer::{Problem, Reduced, ReductionError, check_epsilon};
use super::super::frame_cover::Frame;
use super::order::{by_falling_score, distance_from_axes, scaled, with_kept};
use crate::numeric::linear::dot;
use crate::numeric::scaling::largest_magnitude;
use crate::zonotope::Zonotope;

/// The reduction to a count of generators.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if the box leaves the range of doubles.
pub fn adaptive<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let boxes = GrowingBox::new(problem.body());
    let least = boxes.order.len() - (problem.count() - D);
    boxes.reduced(problem, boxes.bounds[least])
}

/// The reduction to a precision, relative to the diagonal of the bounding box.
///
/// # Errors
/// [`ReductionError::BadEpsilon`] if ε is not in (0, 1), [`ReductionError::OutOfRange`] if the box leaves the range of
/// doubles.
pub fn adaptive_within<const D: usize>(body: &Zonotope<D>, epsilon: f64) -> Result<Reduced<D>, ReductionError> {
    check_epsilon(epsilon)?;
    let boxes = GrowingBox::new(body);
    let everything = Problem::new(body, body.generators().len())?;
    boxes.reduced(&everything, epsilon * boxes.diagonal)
}

/// The generators in the order in which they go into the box.
struct GrowingBox {
    /// The last first.
    order: Vec<usize>,
    /// Twice |Σ v'| over the first m in the box, for m = 0 … n, in units of a power of two.
    bounds: Vec<f64>,
    /// The diagonal of the body's bounding box, in the same units.
    diagonal: f64,
}

impl GrowingBox {
    fn new<const D: usize>(body: &Zonotope<D>) -> Self {
        let vectors = scaled(body.generators());
        let scores: Vec<f64> = vectors.iter().map(distance_from_axes).collect();
        let order = by_falling_score(&scores);
        let mut sum = [0.0; D];
        let mut bounds = vec![0.0];
        for &index in order.iter().rev() {
            let magnitudes = vectors[index].map(f64::abs);
            let largest = largest_magnitude(&magnitudes);
            let axis = magnitudes.iter().position(|c| *c == largest);
            for (k, (sum, c)) in sum.iter_mut().zip(magnitudes).enumerate() {
                *sum += if Some(k) == axis { 0.0 } else { c };
            }
            bounds.push(2.0 * dot(&sum, &sum).sqrt());
        }
        let sides: [f64; D] = std::array::from_fn(|k| vectors.iter().map(|v| v[k].abs()).sum());
        Self { order, bounds, diagonal: 2.0 * dot(&sides, &sides).sqrt() }
    }

    fn reduced<const D: usize>(&self, problem: &Problem<'_, D>, limit: f64) -> Result<Reduced<D>, ReductionError> {
        // the bounds do not fall
        let boxed = self.bounds.partition_point(|bound| *bound <= limit) - 1;
        if boxed <= D && problem.count() == self.order.len() {
            return Ok(Reduced::unreduced(problem.body()));
        }
        with_kept(problem, &self.order[..self.order.len() - boxed], Frame::Axes)
    }
}
