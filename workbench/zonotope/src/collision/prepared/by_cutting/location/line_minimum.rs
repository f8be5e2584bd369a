//! The minimum of the reduced function over the directions u along a cut with u · p = 1, by binary search.
//!
//! These directions are a line; seen from the origin they are the half of the circle with u · p > 0. The generators
//! that turn on this half are contiguous among the 2 k turns of the circle, since u · p changes its sign once on the
//! upper half. Along p × n, the direction of the line, the derivative in a gap is the product with its gradient, and it
//! ascends from gap to gap, as the function is convex.

use std::cmp::Ordering;
use std::ops::Range;

use super::circle::Circle;
use crate::collision::prepared::by_cutting::filtered::{Filtered, Vector, sign_of_determinant};
use crate::collision::prepared::by_cutting::structure::tree::SUM_STEP;
use crate::numeric::exact_linear::{cross, dot, exact};
use crate::tally::{Operation, Tally};

/// Where the minimum is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Minimum {
    /// Where a generator turns: its place on the upper half, and the gap before the turn, on the upper half if it is
    /// less than k.
    Turn { place: usize, gap: usize },
    /// Everywhere: no generator turns on this half, and the gradient is that of a gap.
    Constant { gap: usize },
}

/// The minimum along a circle for a displacement that is not parallel to its normal. O(log k).
pub(crate) fn minimum(
    circle: &Circle<'_>,
    n: &Filtered<impl Vector>,
    p: &Filtered<impl Vector>,
    tally: &mut dyn Tally,
) -> Minimum {
    let count = circle.len();
    let turns = turns_on_half(circle, n, p, tally);
    let around = |turn: usize| if count == 0 { 0 } else { turn % (2 * count) };
    let falls = |gap: usize| {
        tally.add(Operation::Comparison, 1);
        tally.add(Operation::LineEvaluation, circle.steps_to(around(gap)) as u64);
        sign_of_determinant(&Filtered::new(circle.gradient(around(gap))), p, n).is_lt()
    };
    if turns.is_empty() {
        return Minimum::Constant { gap: around(turns.start) };
    }
    // a gap near the middle whose gradient is kept, where there is one
    let probe = |gaps: Range<usize>| {
        let middle = middle_of(gaps.clone());
        let kept = middle - circle.steps_to(around(middle)).min(middle);
        let next = kept + SUM_STEP;
        [kept, next].into_iter().find(|gap| gaps.contains(gap)).unwrap_or(middle)
    };
    let least = partition_point(turns.clone(), falls, probe);
    let turn = around(if least > turns.start { least - 1 } else { least });
    Minimum::Turn { place: turn % count, gap: turn }
}

/// The turns at which u · p > 0, by their numbers around the circle, which may go on beyond 2 k.
fn turns_on_half(
    circle: &Circle<'_>,
    n: &Filtered<impl Vector>,
    p: &Filtered<impl Vector>,
    tally: &mut dyn Tally,
) -> Range<usize> {
    let count = circle.len();
    let mut side = |place: usize| {
        tally.add(Operation::Comparison, 1);
        sign_of_determinant(p, n, &Filtered::new(circle.turned(place)))
    };
    // along the upper half u · p ascends or descends, as the end of this half says; where that is orthogonal to p, all
    // of the half has one sign, that of the reference
    let ascends = match sign_of_determinant(p, &Filtered::new(circle.reference()), n) {
        Ordering::Equal => {
            let [p, reference] = [p.exact(), exact(circle.reference())].map(|v| cross(&v, &circle.normal.exact()));
            dot(&p, &reference).sign().is_lt()
        }
        order => order.is_gt(),
    };
    if ascends {
        let negative = partition_point(0..count, |place| side(place).is_lt(), middle_of);
        let is_level = negative < count && side(negative).is_eq();
        let end = if is_level { count } else { negative };
        let others = partition_point(negative..end, |place| side(place).is_le(), middle_of);
        others..count + negative
    } else {
        let positive = partition_point(0..count, |place| side(place).is_gt(), middle_of);
        let is_level = positive < count && side(positive).is_eq();
        let end = if is_level { count } else { positive };
        let others = partition_point(positive..end, |place| side(place).is_ge(), middle_of);
        count + others..2 * count + positive
    }
}

/// The first of a range that is not before, if all that are before come first; the end if all are. `probe` chooses a
/// member of a range that is not empty.
fn partition_point(
    range: Range<usize>,
    mut is_before: impl FnMut(usize) -> bool,
    probe: impl Fn(Range<usize>) -> usize,
) -> usize {
    let Range { start: mut low, end: mut high } = range;
    while low < high {
        let middle = probe(low..high);
        if is_before(middle) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}

fn middle_of(range: Range<usize>) -> usize {
    range.start + range.len() / 2
}
