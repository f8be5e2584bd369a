//! The Hausdorff distance by the method that the bodies' number of vertices admits.

use super::answer::Distance;
use super::by_branch_and_bound::{Limit, bounded};
use super::by_vertices::farthest;
use super::exact_difference::ExactDifference;
use crate::zonotope::Zonotope;

/// The Hausdorff distance: rounded once where the bodies have few vertices ([`by_vertices`](super::by_vertices)), else
/// between bounds whose ratio is at most 1 + `width`, where the limits of
/// [`by_branch_and_bound`](super::by_branch_and_bound) and rounding allow it.
#[inline(never)]
pub fn hausdorff<const D: usize>(a: &Zonotope<D>, b: &Zonotope<D>, width: f64) -> Distance<D> {
    of_sides(&ExactDifference::new(a, b), &[0, 1], width, Limit::ANSWER)
}

/// The largest distance of a point of `body` from `other`, in the same way.
#[inline(never)]
pub fn excess<const D: usize>(body: &Zonotope<D>, other: &Zonotope<D>, width: f64) -> Distance<D> {
    excess_with_limit(body, other, width, Limit::ANSWER)
}

/// The same with a limit of its own on the work.
pub(in crate::reduction) fn excess_with_limit<const D: usize>(
    body: &Zonotope<D>,
    other: &Zonotope<D>,
    width: f64,
    limit: Limit,
) -> Distance<D> {
    of_sides(&ExactDifference::new(body, other), &[0], width, limit)
}

fn of_sides<const D: usize>(difference: &ExactDifference<D>, sides: &[usize], width: f64, limit: Limit) -> Distance<D> {
    farthest(difference, sides).unwrap_or_else(|| bounded(difference, sides, width, limit))
}
