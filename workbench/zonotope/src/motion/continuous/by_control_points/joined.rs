//! Neighbouring stretches that one direction proves, joined to one.
//!
//! Stretches are halves of each other, and where a direction proves less than a half of one and more than a half of the
//! next, the halves stand apart. A proof of fewer parts is shorter to write and to check.

use super::directions;
use crate::motion::continuous::FreeStretch;
use crate::motion::continuous::moving::Moving;
use crate::tally::Tally;

/// The stretches, each joined with the one before it where a direction proves both.
pub(super) fn joined(moving: &Moving<'_>, free: Vec<FreeStretch>, tally: &mut dyn Tally) -> Vec<FreeStretch> {
    let mut joined: Vec<FreeStretch> = Vec::with_capacity(free.len());
    for stretch in free {
        match joined.last_mut() {
            Some(last) if last.until == stretch.from => match both(moving, last, &stretch, tally) {
                Some(one) => *last = one,
                None => joined.push(stretch),
            },
            _ => joined.push(stretch),
        }
    }
    joined
}

/// One stretch in place of two.
fn both(moving: &Moving<'_>, first: &FreeStretch, second: &FreeStretch, tally: &mut dyn Tally) -> Option<FreeStretch> {
    let times = [first.from, second.until];
    if are_halves(first, second) || !moving.is_whole(times) {
        return None;
    }
    let stretch = moving.rounded_stretch(times);
    let known = [Some(first.direction), Some(second.direction), None];
    let direction = directions::separating(moving, &stretch, times, &known, tally)?;
    Some(FreeStretch { from: first.from, until: second.until, direction })
}

/// Whether two stretches are the halves of one that was not proved.
fn are_halves(first: &FreeStretch, second: &FreeStretch) -> bool {
    let width = first.until - first.from;
    width == second.until - second.from && (first.from / (2.0 * width)).fract() == 0.0
}
