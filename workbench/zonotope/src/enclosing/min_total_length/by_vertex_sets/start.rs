//! The points and sets that set generation begins with.

use super::finer_nets::{along_finer_nets, keep_shorter, multipliers_of};
use super::members::Members;
use super::scalar::Scalar;
use super::vertex_sets::VertexSets;
use super::work::Work;
use crate::enclosing::fixed_directions::Generation;
use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::enclosing::min_total_length::direction_net::{Net, cell_corners};
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::BestBound;
use crate::tally::Tally;

/// The ε of the direction net whose optimum set generation begins with.
const COARSE_NET_EPSILON: f64 = 0.1;

/// The relative precision to which the program along the coarse net is solved.
const COARSE_NET_PRECISION: f64 = 1e-6;

/// Finer nets are tried where ε is at least this share of the gap between the bounds that the coarse net leaves: a net
/// of three times as many directions leaves about an eighth of it.
const LEAST_SHARE_OF_GAP: f64 = 0.12;

/// Finer nets are to bring the bounds within this share of ε: what is left of it is for rounding the generators.
const SHARE_OF_EPSILON: f64 = 0.999;

/// Finer nets are tried where at least this many points have a multiplier: with fewer the interior-point method is
/// faster.
const LEAST_MULTIPLIER_COUNT: usize = 40;

/// Finer nets are tried around at least this many points: around fewer, set generation is fast, and its bound, which is
/// better than that of a net, leaves room for fewer generators.
const LEAST_POINT_COUNT: usize = 64;

/// The beginning of set generation.
pub(super) enum Start<'a, R, const D: usize> {
    /// The points and sets that it begins with.
    Members(Box<Members<'a, R, D>>),
    /// Nothing is left to do: nets of directions have proven the ratio.
    Within,
}

/// The members that set generation begins with: in space those of the optimum along a coarse net; in other dimensions,
/// or if that fails, the farthest points along the axes. The bounds of the net's optimum are kept in `best` and
/// `inner`; where finer nets are likely to bring them within ε, these are tried first.
pub(super) fn start<'a, R: Scalar, const D: usize>(
    frame: &'a Frame<D>,
    coordinates: &'a BoxCoordinates<'a, D>,
    epsilon: f64,
    best: &mut BestBound<D>,
    inner: &mut FrameZonotope<D>,
    work: &mut Work,
    tally: &mut dyn Tally,
) -> Start<'a, R, D> {
    let rank = frame.rank();
    if rank == 3
        && let Some(start) = from_net(frame, coordinates, epsilon, best, inner, work, tally)
    {
        return start;
    }
    let mut members = Members::new(frame, coordinates, VertexSets::new(rank, coordinates, best.lower), Vec::new());
    for axis in 0..rank {
        for sign in [1.0, -1.0] {
            let u: [f64; D] = std::array::from_fn(|c| if c == axis { sign } else { 0.0 });
            members.add(members.farthest(&u), &u);
        }
    }
    Start::Members(Box::new(members))
}

/// The points on the boundary of the shortest zonotope along a coarse net, with their multipliers. The sets are those
/// of the vertices of Σ [−1, 1] λ_j outside the unit ball, and those of a finer net with about twelve directions for
/// each point, so that the first steps do not leave the unit ball far. `None` if the program for the net fails.
fn from_net<'a, R: Scalar, const D: usize>(
    frame: &'a Frame<D>,
    coordinates: &'a BoxCoordinates<'a, D>,
    epsilon: f64,
    best: &mut BestBound<D>,
    inner: &mut FrameZonotope<D>,
    work: &mut Work,
    tally: &mut dyn Tally,
) -> Option<Start<'a, R, D>> {
    let rank = frame.rank();
    let net = Net::Cells.directions(rank, COARSE_NET_EPSILON);
    let weights = vec![1.0; net.len()];
    let mut generation = Generation::new(rank, &frame.points, net, weights, &mut ());
    generation.set_precision(COARSE_NET_PRECISION);
    generation.set_work_limit(work.left_for_nets());
    let ended = generation.run(&mut ());
    work.add_on_nets(generation.work());
    ended.ok()?;
    let multipliers = multipliers_of(&generation);
    if multipliers.len() < 2 {
        return None;
    }
    keep_shorter(coordinates.stretched(FrameZonotope::along(&generation)), inner);
    let far = best.improve(rank, &frame.points, multipliers.clone(), 1.0);
    let is_within = |inner: &FrameZonotope<D>, best: &BestBound<D>, ratio| inner.upper <= (1.0 + ratio) * best.lower;
    let are_many = frame.points.len() >= LEAST_POINT_COUNT && multipliers.len() >= LEAST_MULTIPLIER_COUNT;
    if are_many && is_within(inner, best, epsilon / LEAST_SHARE_OF_GAP) {
        along_finer_nets(frame, coordinates, SHARE_OF_EPSILON * epsilon, best, inner, work, tally);
        if is_within(inner, best, SHARE_OF_EPSILON * epsilon) {
            return Some(Start::Within);
        }
    }
    let multipliers: Vec<(usize, [f64; D])> =
        multipliers.into_iter().map(|(j, f)| (j, f.map(|c| c / far.radius))).collect();
    let places: Vec<usize> = multipliers.iter().map(|(j, _)| *j).collect();
    let points: Vec<[f64; D]> = places.iter().map(|&j| frame.points[j]).collect();
    let cells = (2.0 * (places.len() as f64).sqrt()).ceil() as usize;
    let directions: Vec<[f64; D]> = far.peaks.into_iter().chain(cell_corners(cells)).collect();
    let multipliers = multipliers.into_iter().map(|(_, f)| f).collect();
    let sets = VertexSets::with_multipliers(rank, coordinates, &points, multipliers, &directions);
    Some(Start::Members(Box::new(Members::new(frame, coordinates, sets, places))))
}
