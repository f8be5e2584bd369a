//! Set generation: an interior-point step for the sets so far, the vertices that it leaves too far out, the points outside, repeat.
//!
//! It ends when no vertex of the multipliers' zonotope is beyond the unit ball and no point outside the generators' zonotope by more
//! than ε allows: then the lower and the upper bound meet.

use super::interior::scalar::Scalar;
use super::start::start;
use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::Best;
use crate::tally::{Operation, Tally};
use crate::zonotope::ray_exit::dot;

/// What a search has found.
pub(super) struct Found<const D: usize> {
    pub(super) inner: FrameZonotope<D>,
    /// The best length and the best lower bound after each look at all points.
    pub(super) progress: Vec<[f64; 2]>,
    /// How many sets were tried.
    pub(super) sets: usize,
}

/// At most this many rounds are taken.
const ROUND_LIMIT: usize = 400;

/// After this many rounds without progress, rounding is what is left.
const IDLE_ROUND_LIMIT: usize = 40;

/// Where rounding ends a step, the gap is widened by this factor, and that at most so often.
const RECENTRING_FACTOR: f64 = 100.0;
const RECENTRING_LIMIT: usize = 4;

/// At most this many multiplications and additions are spent, about half a minute's.
const WORK_LIMIT: f64 = 1e11;

/// A step aims at a relative gap of this share of the distance by which the vertices are beyond the unit ball: solving the program
/// for the sets so far more precisely is of no use while sets are missing.
const GAP_SHARE_OF_EXCESS: f64 = 0.3;

/// A step aims at no relative gap below this share of ε.
const GAP_SHARE_OF_EPSILON: f64 = 0.1;

/// The search ends when the bounds differ by this share of ε: rounding takes some of the rest.
const FINAL_SHARE_OF_EPSILON: f64 = 0.25;

/// A vertex inside the unit ball by less than the gap may be beyond it after the next step, so its set is added; but by at most this.
const LARGEST_RELATIVE_MARGIN: f64 = 0.05;

/// Where vertices are beyond the unit ball by more than this multiple of the gap, as after a point near another has joined, the
/// variables are recentred to a gap of the given share of that excess.
const EXCESS_TO_RECENTRE: f64 = 30.0;
const RECENTRED_SHARE_OF_EXCESS: f64 = 0.1;

/// A round counts as progress if the bounds approach each other by more than this share of their distance,
const LEAST_GAIN: f64 = 1e-3;

/// or if gap, excess and stretch together fall below this multiple of their least sum so far.
const LEAST_DOUBT_REDUCTION: f64 = 0.98;

/// The least zonotope around points that span at least three dimensions. `work` is what was spent before, and after the call in all.
pub(super) fn least_by_vertex_sets<R: Scalar, const D: usize>(
    frame: &Frame<D>,
    epsilon: f64,
    best: &mut Best<D>,
    work: &mut f64,
    tally: &mut impl Tally,
) -> Found<D> {
    let coordinates = BoxCoordinates::of(frame);
    let mut inner = coordinates.boxed();
    let mut members = start::<R, D>(frame, &coordinates, best, &mut inner);
    members.sets.work = *work;
    let (mut progress, mut tried, mut idle, mut recentrings) = (Vec::new(), 0, 0, 0);
    let (mut excess, mut least_doubt) = (0.0, f64::INFINITY);
    for _ in 0..ROUND_LIMIT {
        tally.add(Operation::SearchStep, 1);
        members.sets.prune();
        let count = members.sets.sets.len() as f64;
        let least_gap = f64::max(GAP_SHARE_OF_EXCESS * excess, GAP_SHARE_OF_EPSILON * epsilon) * members.sets.length;
        let Some(stepped) = members.sets.step(least_gap / count) else {
            // Variables so near the boundary of the cone that rounding takes them beyond it begin anew farther inside.
            recentrings += 1;
            if recentrings > RECENTRING_LIMIT {
                break;
            }
            members.sets.recentre(RECENTRING_FACTOR * members.sets.mu * count);
            continue;
        };
        let (center, sets, generators) = members.zonotope(stepped.generators);
        let gap = (stepped.mu * count / members.sets.length).min(LARGEST_RELATIVE_MARGIN);
        let look = members.look(center, &generators);
        tally.add(Operation::PointRead, frame.points.len() as u64);
        let before = (inner.upper, best.lower);
        let length: f64 = generators.iter().map(|g| dot(g, g).sqrt()).sum::<f64>() + stepped.missed.iter().sum::<f64>();
        if look.stretch * length < inner.upper {
            let generators = generators.iter().map(|g| g.map(|c| c * look.stretch)).collect();
            let witnesses = members.witnesses(&sets, 1.0 / look.stretch);
            inner = FrameZonotope { upper: look.stretch * length, center, generators, witnesses };
        }
        let far = best.improve(frame.rank(), &frame.points, members.balanced_multipliers(), 1.0 - gap);
        excess = far.radius - 1.0;
        if best.lower > before.1 {
            members.sets.length = best.lower;
        }
        progress.push([inner.upper, best.lower]);
        if inner.upper <= (1.0 + FINAL_SHARE_OF_EPSILON * epsilon) * best.lower {
            break;
        }
        let gain = before.0 - inner.upper + best.lower - before.1;
        let doubt = stepped.mu * count / members.sets.length + excess + look.stretch - 1.0;
        let is_progress = gain > LEAST_GAIN * (inner.upper - best.lower) || doubt < LEAST_DOUBT_REDUCTION * least_doubt;
        idle = if is_progress { 0 } else { idle + 1 };
        least_doubt = doubt.min(least_doubt);
        if idle > IDLE_ROUND_LIMIT || members.sets.work > WORK_LIMIT {
            break;
        }
        let mut others = far.on_circles;
        others.sort_by(|a, b| dot(b, b).total_cmp(&dot(a, a)));
        others.truncate(members.places.len() / 2);
        for vertex in far.peaks.iter().chain(&others) {
            tried += usize::from(members.sets.add_set_along(vertex));
        }
        members.sets.recentre((look.stretch - 1.0).min(LARGEST_RELATIVE_MARGIN) * members.sets.length);
        if excess > EXCESS_TO_RECENTRE * gap {
            members.sets.recentre(RECENTRED_SHARE_OF_EXCESS * excess.min(1.0) * members.sets.length);
        }
        let points = members.places.len();
        members.add_outside(look.outside);
        if members.places.len() > points {
            (idle, least_doubt) = (0, f64::INFINITY);
        }
    }
    *work = members.sets.work;
    Found { inner, progress, sets: tried }
}
