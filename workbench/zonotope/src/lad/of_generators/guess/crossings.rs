//! The weighted median of the places at which lines are crossed, by selection.

use crate::numeric::weighted_median::weighted_median;

/// A crossing on a line that is searched: its place along the line, and half of what the slope gains there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crossing {
    pub(crate) position: f64,
    pub(crate) weight: f64,
    pub(crate) line: usize,
}

/// The first crossing, by position and then by line, at which the weights up to it and with it reach `target`; the
/// last one if they never do.
pub(crate) fn select(crossings: &mut [Crossing], target: f64) -> Option<Crossing> {
    let order = |a: &Crossing, b: &Crossing| a.position.total_cmp(&b.position).then(a.line.cmp(&b.line));
    weighted_median(crossings, target, order, |c| c.weight).copied()
}
