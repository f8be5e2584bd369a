//! Set generation: the loop that solves the dual program for some sets and adds those whose constraints are violated.
//!
//! Each round takes one interior-point step for the sets so far, then looks for vertices of Σ [−1, 1] λ_j outside the
//! unit ball and for points outside the zonotope of the generators. One step is enough for a round: the program changes
//! in the next one. The loop ends when neither the vertices nor the points are farther out than ε allows, for then the
//! lower and the upper bound are within ε.

use super::finer_nets::along_finer_nets;
use super::scalar::Scalar;
use super::start::{Start, start};
use super::work::Work;
use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::BestBound;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};

/// The shortest zonotope that set generation has found.
pub(super) struct Found<const D: usize> {
    pub(super) inner: FrameZonotope<D>,
    /// The least length and the greatest lower bound after each round.
    pub(super) progress: Vec<[f64; 2]>,
    /// How many sets were added.
    pub(super) sets: usize,
}

/// Set generation ends after this many rounds.
const ROUND_LIMIT: usize = 400;

/// Set generation ends after this many rounds in sequence without progress: rounding errors are as large as the gap
/// then.
const IDLE_ROUND_LIMIT: usize = 40;

/// Where rounding takes a step out of the cone, the duality gap is widened by this factor before the next attempt.
const RECENTRING_FACTOR: f64 = 100.0;

/// Set generation ends when rounding has taken more steps than this out of the cone.
const RECENTRING_LIMIT: usize = 4;

/// All points are looked at where the zonotope would close this share of the gap between the bounds.
const SHARE_WORTH_A_LOOK: f64 = 0.1;

/// A step aims at a relative duality gap of this share of the excess, the distance of the farthest vertex from the unit
/// ball: solving the program more precisely is of no use while sets are missing.
const GAP_SHARE_OF_EXCESS: f64 = 0.3;

/// A step aims at no relative duality gap below this share of ε.
const GAP_SHARE_OF_EPSILON: f64 = 0.1;

/// Set generation ends when the bounds are within this share of ε: what is left of ε is for rounding the generators.
const FINAL_SHARE_OF_EPSILON: f64 = 0.25;

/// The sets of vertices in the unit ball are added, too, if they are nearer to its boundary than the relative duality
/// gap, since the next step may take them out of the ball; but not those farther from the boundary than this.
const LARGEST_RELATIVE_MARGIN: f64 = 0.05;

/// If the excess is more than this multiple of the relative duality gap, as after a point near another one has got a
/// multiplier, the variables are recentred.
const EXCESS_TO_RECENTRE: f64 = 30.0;

/// Recentring for a large excess widens the relative duality gap to this share of the excess.
const RECENTRED_SHARE_OF_EXCESS: f64 = 0.1;

/// A round is progress if the bounds approach each other by more than this share of their distance.
const LEAST_GAIN: f64 = 1e-3;

/// A round is progress, too, if its error (gap, excess and stretch together) falls below this multiple of the least
/// error so far.
const LEAST_ERROR_REDUCTION: f64 = 0.98;

/// The shortest zonotope around the points of a frame that set generation finds, for any rank from 3; `best` keeps the
/// best lower bound. The work goes on from its value at the call.
pub(super) fn min_length_by_set_generation<R: Scalar, const D: usize>(
    frame: &Frame<D>,
    epsilon: f64,
    best: &mut BestBound<D>,
    work: &mut Work,
    tally: &mut dyn Tally,
) -> Found<D> {
    let coordinates = BoxCoordinates::of(frame);
    let mut inner = coordinates.boxed();
    let mut members = match start::<R, D>(frame, &coordinates, epsilon, best, &mut inner, work, tally) {
        Start::Members(members) => *members,
        Start::Within => return Found { progress: vec![[inner.upper, best.lower]], inner, sets: 0 },
    };
    members.sets.work += work.on_sets;
    let (mut progress, mut tried, mut idle, mut recentrings) = (Vec::new(), 0, 0, 0);
    let (mut excess, mut least_error) = (0.0, f64::INFINITY);
    for _ in 0..ROUND_LIMIT {
        tally.add(Operation::SearchStep, 1);
        members.sets.prune();
        let count = members.sets.sets.len() as f64;
        let least_gap = f64::max(GAP_SHARE_OF_EXCESS * excess, GAP_SHARE_OF_EPSILON * epsilon) * members.sets.length;
        let Some(stepped) = members.sets.step(least_gap / count) else {
            // Rounding took variables near the boundary of the cone out of it; the next attempt begins farther inside.
            recentrings += 1;
            if recentrings > RECENTRING_LIMIT {
                break;
            }
            members.sets.recentre(RECENTRING_FACTOR * members.sets.mu * count);
            continue;
        };
        let (center, sets, generators) = members.zonotope(stepped.generators);
        let gap = (stepped.mu * count / members.sets.length).min(LARGEST_RELATIVE_MARGIN);
        let mut outside = members.points_likely_outside(center, &generators);
        tally.add(Operation::PointRead, outside.looked_at as u64);
        let before = (inner.upper, best.lower);
        let length: f64 = generators.iter().map(|g| dot(g, g).sqrt()).sum::<f64>() + stepped.missed.iter().sum::<f64>();
        let far = best.improve(frame.rank(), &frame.points, members.balanced_multipliers(), 1.0 - gap);
        // A zonotope counts once all points have been looked at, which is worth the while where it may be much better.
        let upper = outside.stretch * length;
        let enough = (1.0 + FINAL_SHARE_OF_EPSILON * epsilon) * best.lower;
        let is_much_less = inner.upper - upper >= SHARE_WORTH_A_LOOK * (inner.upper - best.lower);
        if !outside.is_of_all && upper < inner.upper && (is_much_less || upper <= enough) {
            outside = members.all_points_outside(center, &generators);
            tally.add(Operation::PointRead, outside.looked_at as u64);
        }
        if outside.is_of_all && outside.stretch * length < inner.upper {
            let generators = generators.iter().map(|g| g.map(|c| c * outside.stretch)).collect();
            let witnesses = members.witnesses(&sets, 1.0 / outside.stretch);
            inner = FrameZonotope { upper: outside.stretch * length, center, generators, witnesses };
        }
        excess = far.radius - 1.0;
        if best.lower > before.1 {
            members.sets.length = best.lower;
        }
        progress.push([inner.upper, best.lower]);
        if inner.upper <= enough {
            break;
        }
        let gain = before.0 - inner.upper + best.lower - before.1;
        let error = stepped.mu * count / members.sets.length + excess + outside.stretch - 1.0;
        let is_progress = gain > LEAST_GAIN * (inner.upper - best.lower) || error < LEAST_ERROR_REDUCTION * least_error;
        idle = if is_progress { 0 } else { idle + 1 };
        least_error = error.min(least_error);
        work.on_sets = members.sets.work;
        if idle > IDLE_ROUND_LIMIT || work.is_used_up(frame.rank()) {
            break;
        }
        let mut others = far.on_circles;
        others.sort_by(|a, b| dot(b, b).total_cmp(&dot(a, a)));
        others.truncate(members.places.len() / 2);
        for vertex in far.peaks.iter().chain(&others) {
            tried += usize::from(members.sets.add_set_along(vertex));
        }
        members.sets.recentre((outside.stretch - 1.0).min(LARGEST_RELATIVE_MARGIN) * members.sets.length);
        if excess > EXCESS_TO_RECENTRE * gap {
            members.sets.recentre(RECENTRED_SHARE_OF_EXCESS * excess.min(1.0) * members.sets.length);
        }
        let points = members.places.len();
        members.add_outside(outside.points);
        if members.places.len() > points {
            (idle, least_error) = (0, f64::INFINITY);
        }
    }
    work.on_sets = members.sets.work;
    // Nets take their time whatever the number of points, and prove some ratio in any case.
    if frame.rank() == 3 && work.is_used_up(3) {
        along_finer_nets(frame, &coordinates, epsilon, best, &mut inner, work, tally);
        progress.push([inner.upper, best.lower]);
    }
    Found { inner, progress, sets: tried }
}
