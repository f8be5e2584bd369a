//! The least zonotope along the directions of a net, with a lower bound for all directions.
//!
//! Few of the directions bear anything. So the program is solved for a part of them; its multipliers load others beyond
//! their limit of 1, which join it, until none does: then the optimum is that of the whole net.

use crate::enclosing::fixed_directions::{Generation, balanced};
use crate::enclosing::min_total_length::answer::{MinLengthError, MinLengthZonotope};
use crate::enclosing::min_total_length::conclude::{around_equal_points, conclude};
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::Best;
use crate::zonotope::ray_exit::dot;

/// How precisely the program for the whole net is solved, and limits are kept, relative to ε.
const PRECISION_SHARE_OF_EPSILON: f64 = 1e-3;

/// Of a net of more directions than this, and than this for each point, a part comes first: many points use many
/// directions.
const WHOLE_NET_LIMIT: usize = 250;
const DIRECTIONS_PER_POINT_LIMIT: usize = 25;

/// At most this many directions join the program at once; its first part has about as many.
const PART_SIZE: usize = 60;

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
    let net = net(rank);
    let mut is_chosen = vec![false; net.len()];
    let stride = if net.len() > WHOLE_NET_LIMIT.max(DIRECTIONS_PER_POINT_LIMIT * points.len()) {
        net.len() / PART_SIZE
    } else {
        1
    };
    is_chosen.iter_mut().step_by(stride).for_each(|chosen| *chosen = true);
    let precision = PRECISION_SHARE_OF_EPSILON * epsilon.clamp(1e-10, 1e-4);
    let (mut best, mut progress) = (Best::none(), Vec::new());
    loop {
        let chosen = net.iter().zip(&is_chosen).filter(|(_, chosen)| **chosen);
        let directions: Vec<[f64; D]> = chosen.map(|(v, _)| *v).collect();
        let weights = vec![1.0; directions.len()];
        let mut generation = Generation::new(rank, &frame.points, directions, weights, &mut ());
        if stride == 1 {
            generation.set_precision(precision);
        }
        // Where it gets stuck, what it has is proven all the same, and the ratio tells how good that is.
        let is_stuck = generation.run(&mut ()).is_err();
        let program = &generation.program;
        let pulls: Vec<(usize, [f64; D])> =
            program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
        let pulls = balanced(&pulls);
        let load = |v: &[f64; D]| pulls.iter().map(|(_, pull)| dot(pull, v).abs()).sum::<f64>();
        let others = (0..net.len()).filter(|&i| !is_chosen[i]);
        let mut loaded: Vec<(f64, usize)> = others.map(|i| (load(&net[i]), i)).collect();
        loaded.retain(|(load, _)| is_stuck || *load > 1.0 + precision);
        loaded.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        best.improve(rank, &frame.points, pulls, f64::INFINITY);
        let inner = FrameZonotope::along(&generation);
        progress.push([inner.upper, best.lower]);
        if loaded.is_empty() {
            return conclude(points, &frame, inner, &best, progress, net.len(), epsilon);
        }
        loaded.iter().take(if is_stuck { net.len() } else { PART_SIZE }).for_each(|(_, i)| is_chosen[*i] = true);
    }
}
