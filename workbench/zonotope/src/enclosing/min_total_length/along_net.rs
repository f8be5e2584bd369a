//! The least zonotope along the directions of a net, with a lower bound for all directions.

use super::answer::{MinLengthError, MinLengthZonotope};
use super::finish::{Inner, around_equal_points, finish};
use super::frame::Frame;
use super::lower_bound::Best;
use crate::enclosing::fixed_directions::{Generation, balanced};

/// How precisely the program is solved, relative to ε.
const PRECISELY: f64 = 1e-3;

/// Solves along the directions that `net` gives for a number of dimensions.
pub(super) fn least_along<const D: usize>(
    points: &[[f64; D]],
    net: impl FnOnce(usize) -> Vec<[f64; D]>,
    epsilon: f64,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let frame = Frame::new(points);
    let rank = frame.rank();
    if rank == 0 {
        return around_equal_points(points);
    }
    let directions = net(rank);
    let tried = directions.len();
    let weights = vec![1.0; tried];
    let mut generation = Generation::new(rank, &frame.points, directions, weights, &mut ());
    generation.set_precision(PRECISELY * epsilon.clamp(1e-10, 1e-4));
    // Where it gets stuck, what it has is proven all the same, and the ratio tells how good that is.
    let _ = generation.run(&mut ());
    let program = &generation.program;
    let pulls: Vec<(usize, [f64; D])> =
        program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
    let mut best = Best::none();
    best.improve(rank, &frame.points, balanced(&pulls), f64::INFINITY);
    let inner = Inner::along(&generation);
    let progress = vec![[inner.upper, best.lower]];
    finish(points, &frame, inner, &best, progress, tried, epsilon)
}
