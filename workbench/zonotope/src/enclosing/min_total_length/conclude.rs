//! The last step of every method: from a zonotope in the frame and multipliers to an answer with its proofs.

use super::answer::{LengthProof, MinLengthError, MinLengthZonotope, Outcome};
use super::contain::around;
use super::frame::Frame;
use super::frame_zonotope::FrameZonotope;
use super::lower_bound::BestBound;
use super::sheared_box::shortest_box_around;
use crate::enclosing::answer::{Effort, Enclosing};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::zonotope::Zonotope;

/// Refuses points that are not finite, no points at all, and an ε outside (0, 1).
pub(super) fn validate<const D: usize>(points: &[[f64; D]], epsilon: f64) -> Result<(), MinLengthError> {
    NonFinite::check_list("point", points)?;
    if points.is_empty() {
        return Err(MinLengthError::Empty);
    }
    if epsilon > 0.0 && epsilon < 1.0 { Ok(()) } else { Err(MinLengthError::BadEpsilon(epsilon)) }
}

/// The answer, in units of the input, from a zonotope of the frame: its generators rounded and lengthened to contain
/// every point, its length set against the best lower bound.
pub(super) fn conclude<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    inner: FrameZonotope<D>,
    best: &BestBound<D>,
    progress: Vec<[f64; 2]>,
    directions: usize,
    epsilon: f64,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let boxed = || shortest_box_around(points).ok_or(MinLengthError::OutOfRange);
    let around = around(points, frame, &inner).map_or_else(boxed, Ok)?;
    let in_units = |v: f64| scale_by_power_of_two(v, frame.exponent);
    let progress = progress.into_iter().map(|bounds| bounds.map(in_units)).collect();
    Ok(proven(points, frame, around, best, progress, directions, epsilon))
}

/// The answer from a zonotope that contains the points, given with an upper bound of its length.
pub(super) fn proven<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    (zonotope, length): (Zonotope<D>, f64),
    best: &BestBound<D>,
    progress: Vec<[f64; 2]>,
    directions: usize,
    epsilon: f64,
) -> MinLengthZonotope<D> {
    let (lower_bound, multipliers) = best.proven(points, frame);
    let effort = Effort { rows: directions, rounds: progress.len(), progress, ..Effort::default() };
    let proof = LengthProof { multipliers, outcome: Outcome::WithinEpsilon };
    let mut answer = Enclosing { body: zonotope, value: length, lower_bound, proof, effort };
    if answer.ratio() > 1.0 + epsilon {
        answer.proof.outcome = Outcome::EndedBefore;
    }
    answer
}

/// The answer for points that are all equal: the point itself, of length zero.
pub(super) fn around_equal_points<const D: usize>(points: &[[f64; D]]) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let zonotope = Zonotope::new(points[0], Vec::new()).map_err(|_| MinLengthError::OutOfRange)?;
    let proof = LengthProof { multipliers: Vec::new(), outcome: Outcome::WithinEpsilon };
    Ok(Enclosing { body: zonotope, value: 0.0, lower_bound: 0.0, proof, effort: Effort::default() })
}
