//! A guess of when two bodies meet: where the gap along a direction that separates them at the begin of a stretch
//! vanishes.
//!
//! Along any direction the gap vanishes before the bodies meet. They touch with a vertex and a face or with two edges,
//! and the normal of these moves with the bodies: along a direction that moves in that way, the time that is left
//! shrinks like that of Newton's method. A direction that stays in space does not: the face tilts, and its farthest
//! corner takes its gap away at a rate of its own, so that each guess leaves the same share of the time.

use super::super::SeparatingDirection;
use super::super::gap::{GapBound, Stretch};
use super::super::moving::Moving;
use super::edges;
use crate::motion::quaternion::transposed_image;
use crate::tally::{Operation, Tally};
use smallvec::SmallVec;

/// The share of the time until the gap vanishes that is left out: the gap at the end of the stretch must be positive.
const SHARE_LEFT_OUT: f64 = 1.0 / 256.0;

/// The part of a stretch that is looked at again is so many times as long as the gap takes to vanish.
const LOOKED_AT: f64 = 16.0;

/// The number of parts of a stretch at whose ends the gap is looked at for a change of sign, and of halvings of the
/// first part with one.
const SAMPLES: u32 = 16;
const HALVINGS: u32 = 20;

/// The latest time within a stretch before which a candidate keeps a gap, and the candidate, which may prove what is
/// before. All of them start from a direction that separates the bodies at the begin of the stretch.
pub(in crate::motion::continuous) fn latest_gap(
    moving: &Moving<'_>,
    mut times: [f64; 2],
    hint: &SeparatingDirection,
    resolution: f64,
    tally: &mut dyn Tally,
) -> Option<(f64, SeparatingDirection)> {
    if !moving.is_whole(times) {
        return None;
    }
    let mut next = |stretch: &Stretch<'_, f64>, direction: &SeparatingDirection, times: [f64; 2]| {
        tally.add(Operation::SupportEvaluation, stretch.support_evaluations(direction));
        next_time(&stretch.gap_along(direction), times, resolution)
    };
    let mut stretch = moving.rounded_stretch(times);
    let first = next(&stretch, hint, times)?;
    if let Some(shorter) = shorter(times, first) {
        times = shorter;
        stretch = moving.rounded_stretch(times);
    }
    let mut best: Option<(f64, SeparatingDirection)> = None;
    for direction in candidates(&stretch, hint) {
        let time = next(&stretch, &direction, times);
        if let Some(time) = time.filter(|&time| best.is_none_or(|(latest, _)| latest < time)) {
            best = Some((time, direction));
        }
    }
    best
}

/// Directions that are, at the begin of a stretch, a given one or near it, and that move with the bodies or stay.
fn candidates(stretch: &Stretch<'_, f64>, given: &SeparatingDirection) -> SmallVec<[SeparatingDirection; 4]> {
    let mut candidates = SmallVec::from_iter([*given]);
    let Some(u) = given.fixed_in_space() else { return candidates };
    let turns = [0, 1].map(|i| !stretch.arcs[i].is_translation);
    let turned_back = |i: usize| transposed_image(&stretch.rotations[i][0], &u);
    if turns[0] {
        candidates.push(SeparatingDirection::First(turned_back(0)));
    }
    if turns[1] {
        candidates.push(SeparatingDirection::Second(turned_back(1)));
    }
    if turns != [false; 2] {
        candidates.extend(edges::normals(stretch, u).next());
    }
    candidates
}

/// A time strictly inside a stretch to ask about next: a little before the gap vanishes, or where that is near enough,
/// less than the resolution after the begin. `None` where the gap says nothing.
fn next_time(gap: &GapBound<f64>, [from, until]: [f64; 2], resolution: f64) -> Option<f64> {
    let width = until - from;
    let left = width * first_zero(gap)?;
    let step = if left <= resolution / 2.0 {
        0.875 * resolution
    } else {
        left - (SHARE_LEFT_OUT * left).max(resolution / 4.0)
    };
    let time = from + step;
    (from < time && time < until).then_some(time)
}

/// The first part of a stretch in which a gap vanishes early, for a second look: rotations at constant rate are off
/// their stretch by the third power of its length, and the gap is less by that.
fn shorter([from, until]: [f64; 2], vanishing: f64) -> Option<[f64; 2]> {
    let left = vanishing - from;
    let end = from + LOOKED_AT * left;
    (from < end && end < until).then_some([from, end])
}

/// The first change of the sign of a polynomial that is positive at 0, in [0, 1]; 1 where there is none.
fn first_zero(gap: &[f64; 6]) -> Option<f64> {
    if gap[0].is_nan() || gap[0] <= 0.0 {
        return None;
    }
    let is_positive = |s: f64| value(gap, s) > 0.0;
    let Some(part) = (1..=SAMPLES).find(|&part| !is_positive(f64::from(part) / f64::from(SAMPLES))) else {
        return Some(1.0);
    };
    let [mut low, mut high] = [part - 1, part].map(|part| f64::from(part) / f64::from(SAMPLES));
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if is_positive(middle) { low = middle } else { high = middle }
    }
    // a zero that is much nearer than the part is wide
    while low == 0.0 && high > 1e-12 {
        if is_positive(high / 2.0) { low = high / 2.0 } else { high /= 2.0 }
    }
    Some(high)
}

/// The value of a polynomial by its scaled Bernstein coefficients.
fn value(gap: &[f64; 6], s: f64) -> f64 {
    let r = 1.0 - s;
    let [a, b, c, d, e, f] = gap;
    let (ss, rr) = (s * s, r * r);
    rr * rr * (a * r + b * s) + rr * ss * (c * r + d * s) + ss * ss * (e * r + f * s)
}
