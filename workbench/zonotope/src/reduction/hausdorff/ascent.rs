//! A lower bound of a distance that rounding hides: the difference of the support functions along directions of
//! doubles, exactly.
//!
//! The difference along u is u · g for the vector g from the nearer body's extreme point to that of the farther one. No
//! direction is better for these two points than g itself, so the next direction is g, rounded. Steps go on while the
//! difference grows, a few from each start. O(n) exact operations a step.

use std::array;

use super::exact_difference::ExactDifference;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::root::Root;
use crate::numeric::linear::sum_of_products;

/// The steps from one start.
const STEPS: usize = 8;

/// The greatest double that is not above the difference for one side along some direction, and that direction.
pub(super) fn climbed<const D: usize>(
    exact: &ExactDifference<D>,
    side: usize,
    start: [f64; D],
) -> Option<(f64, [f64; D])> {
    let mut best: Option<(f64, [f64; D])> = None;
    let mut direction = start;
    for _ in 0..STEPS {
        let u = direction.map(Dyadic::from_f64);
        let gap = gap(exact, side, &u);
        let value = sum_of_products(&gap, &u);
        if value.sign().is_le() {
            break;
        }
        let square = (&value * &value).to_rational() / sum_of_products(&u, &u).to_rational();
        let below = Root::of(&square, 0).below;
        if best.is_some_and(|(most, _)| below <= most) {
            break;
        }
        best = Some((below, direction));
        let exponent = gap.iter().filter_map(Dyadic::binary_exponent).max()?;
        direction = gap.map(|c| c.scaled(-exponent).to_f64());
    }
    best
}

/// From the extreme point of the nearer body along u to that of the farther one, from whose centre the displacement
/// leads away along u.
fn gap<const D: usize>(exact: &ExactDifference<D>, side: usize, u: &[Dyadic; D]) -> [Dyadic; D] {
    let farther = exact.generators[side].iter().chain([&exact.displacement]).map(|g| (g, true));
    let nearer = exact.generators[1 - side].iter().map(|g| (g, false));
    let mut gap: [Dyadic; D] = array::from_fn(|_| Dyadic::zero());
    for (g, is_farther) in farther.chain(nearer) {
        let is_added = sum_of_products(g, u).sign().is_ge() == is_farther;
        gap = array::from_fn(|k| if is_added { &gap[k] + &g[k] } else { &gap[k] - &g[k] });
    }
    gap
}
