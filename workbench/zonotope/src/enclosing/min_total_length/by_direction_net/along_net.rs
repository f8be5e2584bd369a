//! The shortest zonotope along the directions of a net, with a lower bound for all directions.
//!
//! In the optimum few directions of a net have a generator. So the linear program is solved for a part of the
//! directions. The dual constraint of a direction v is Σ_j |λ_j · v| ≤ 1 for the multipliers λ_j; directions whose
//! constraint the multipliers violate join the part, until there are none. The optimum for the part is that of the
//! whole net then. Every part has a zonotope around all points and a lower bound for all directions, so the work can
//! end at any of them.

use crate::enclosing::fixed_directions::{Generation, balanced};
use crate::enclosing::min_total_length::answer::{MinLengthError, MinLengthZonotope};
use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::enclosing::min_total_length::by_vertex_sets::limit_around;
use crate::enclosing::min_total_length::conclude::{around_equal_points, conclude};
use crate::enclosing::min_total_length::direction_net::Net;
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::BestBound;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};

/// The relative precision, as a share of ε, to which dual constraints hold at the end; the program for a whole net is
/// solved as precisely.
const PRECISION_SHARE_OF_EPSILON: f64 = 1e-3;

/// A net of at most this many directions is solved as a whole,
const WHOLE_NET_LIMIT: usize = 250;

/// and so is a net of at most this many directions for each point: many points use many directions.
const DIRECTIONS_PER_POINT_LIMIT: usize = 25;

/// unless it has more directions than the limit of the net: a program takes time in proportion to the cube of their
/// number.
const LARGEST_WHOLE_NET: usize = 600;

/// Limit of the entries and products of points of the programs, around up to a thousand points; then the answer is the
/// best of the zonotopes of the parts so far. Around more points the limit is greater.
const WORK_LIMIT: u64 = 1 << 29;

/// The limits of the programs along a net.
#[derive(Debug, Clone, Copy)]
struct Limits {
    /// The most directions of a net that is taken whole for the sake of many points.
    largest_whole_net: usize,
    /// The most entries and products of points.
    work: u64,
}

impl Limits {
    /// The limits for a net around so many points. The paper's net has none, so that its cost is the one that the paper
    /// states.
    fn of(net: Net, points: usize) -> Self {
        match net {
            Net::Paper => Self { largest_whole_net: usize::MAX, work: u64::MAX },
            Net::Cells => Self { largest_whole_net: LARGEST_WHOLE_NET, work: limit_around(points, WORK_LIMIT) },
        }
    }
}

/// At most this many directions join the program in a round, and it begins with about as many.
const PART_SIZE: usize = 60;

/// The shortest zonotope around points along the directions of a net in the dimensions of their affine hull.
pub(super) fn min_length_along_net<const D: usize>(
    points: &[[f64; D]],
    net: Net,
    epsilon: f64,
    tally: &mut dyn Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let frame = Frame::new(points);
    let rank = frame.rank();
    if rank == 0 {
        return around_equal_points(points);
    }
    let limits = Limits::of(net, points.len());
    let net: Vec<[f64; D]> = net.directions(rank, epsilon);
    let mut is_chosen = vec![false; net.len()];
    let largest_whole = WHOLE_NET_LIMIT.max(limits.largest_whole_net.min(DIRECTIONS_PER_POINT_LIMIT * points.len()));
    let stride = if net.len() > largest_whole { net.len() / PART_SIZE } else { 1 };
    is_chosen.iter_mut().step_by(stride).for_each(|chosen| *chosen = true);
    let precision = PRECISION_SHARE_OF_EPSILON * epsilon.clamp(1e-10, 1e-4);
    let (mut best, mut progress) = (BestBound::none(), Vec::new());
    let coordinates = BoxCoordinates::of(&frame);
    let (mut shortest, mut work) = (coordinates.boxed(), 0);
    loop {
        let chosen = net.iter().zip(&is_chosen).filter(|(_, chosen)| **chosen);
        let directions: Vec<[f64; D]> = chosen.map(|(v, _)| *v).collect();
        let weights = vec![1.0; directions.len()];
        let mut generation = Generation::new(rank, &frame.points, directions, weights, tally);
        if stride == 1 {
            generation.set_precision(precision);
        }
        generation.set_work_limit(limits.work.saturating_sub(work));
        // A generation that gets stuck leaves a zonotope and multipliers that are proven like any others; the ratio
        // says how good they are. The next round takes the whole net.
        let is_stuck = generation.run(tally).is_err();
        work += generation.work();
        let program = &generation.program;
        let unbalanced: Vec<(usize, [f64; D])> =
            program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
        let multipliers = balanced(&unbalanced);
        let activity = |v: &[f64; D]| multipliers.iter().map(|(_, f)| dot(f, v).abs()).sum::<f64>();
        let other_count = is_chosen.iter().filter(|chosen| !**chosen).count();
        tally.add(Operation::GeneratorRead, other_count as u64 * multipliers.len() as u64);
        let others = (0..net.len()).filter(|&i| !is_chosen[i]);
        let mut joining: Vec<(f64, usize)> = others.map(|i| (activity(&net[i]), i)).collect();
        joining.retain(|(activity, _)| is_stuck || *activity > 1.0 + precision);
        joining.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        best.improve(rank, &frame.points, multipliers, f64::INFINITY);
        let mut inner = FrameZonotope::along(&generation);
        let is_used_up = is_stuck && work >= limits.work;
        if joining.is_empty() && !is_used_up {
            progress.push([inner.upper, best.lower]);
            return conclude(points, &frame, inner, &best, progress, net.len(), epsilon);
        }
        if is_stuck {
            inner = coordinates.stretched(inner);
        }
        if inner.upper < shortest.upper {
            shortest = inner;
        }
        progress.push([shortest.upper, best.lower]);
        if is_used_up || work >= limits.work {
            return conclude(points, &frame, shortest, &best, progress, net.len(), epsilon);
        }
        joining.iter().take(if is_stuck { net.len() } else { PART_SIZE }).for_each(|(_, i)| is_chosen[*i] = true);
    }
}
