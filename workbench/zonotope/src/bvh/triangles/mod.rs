//! Problem: whether two closed triangles of space have a point in common, and how far apart they are.
//!
//! Triangles are three corners each, in any position: flat to a segment or a point, in one plane, touching. Corners are
//! exact numbers, as poses make them.
//!
//! | file | answers | cost |
//! |---|---|---|
//! | `plane` | pairs that the plane of one separates, in doubles with one bound for all rounding | 3 heights |
//! | [`by_planes`] | pairs in general position, over any numbers with certain signs | 2 planes, then at most 18 volumes |
//! | [`by_separating_planes`] | all pairs, in exact numbers | 29 directions |
//! | [`brute_force`] | all pairs, in rationals: the truth | a linear program of nine unknowns |
//! | [`distance`] | bounds of the distance, in doubles and exactly | 15 pairs of features |
//!
//! `meet_exactly` is the exact answer: the first where signs decide, else the second.

pub mod brute_force;
pub mod by_planes;
pub mod by_separating_planes;
pub mod distance;
pub(in crate::bvh) mod plane;
#[cfg(test)]
mod tests;

use crate::numeric::exact_linear::ExactVector;

/// Whether two triangles with exact corners have a point in common.
pub(crate) fn meet_exactly(a: &[ExactVector; 3], b: &[ExactVector; 3]) -> bool {
    by_planes::meet(a, b).unwrap_or_else(|| by_separating_planes::meet(a, b))
}
