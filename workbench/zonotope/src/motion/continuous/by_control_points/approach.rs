//! A guess of when two bodies meet: where the gap along a direction that separates them at the begin of a stretch
//! vanishes.
//!
//! Along any direction the gap vanishes before the bodies meet, and near the contact a separating direction is mostly
//! the normal of the faces that will touch: the time that is left shrinks like that of Newton's method.

use super::super::gap::GapBound;

/// The share of the time until the gap vanishes that is left out: the gap at the end of the stretch must be positive.
const SHARE_LEFT_OUT: f64 = 1.0 / 256.0;

/// Parts of a stretch in which the gap is looked at for a change of sign, and halvings of that part.
const PARTS: u32 = 16;
const HALVINGS: u32 = 20;

/// A time strictly inside a stretch to ask about next: a little before the gap vanishes, or where that is near enough,
/// less than the resolution after the begin. `None` where the gap says nothing.
pub(super) fn next_time(gap: &GapBound<f64>, [from, until]: [f64; 2], resolution: f64) -> Option<f64> {
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

/// The first change of the sign of a polynomial that is positive at 0, in [0, 1].
fn first_zero(gap: &[f64; 6]) -> Option<f64> {
    if gap[0].is_nan() || gap[0] <= 0.0 {
        return None;
    }
    let is_positive = |s: f64| value(gap, s) > 0.0;
    let part = (1..=PARTS).find(|&part| !is_positive(f64::from(part) / f64::from(PARTS)))?;
    let [mut low, mut high] = [part - 1, part].map(|part| f64::from(part) / f64::from(PARTS));
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
