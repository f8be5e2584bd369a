//! The weighted median of the places at which lines are crossed, by selection.

/// A crossing of a line that is searched: where, and half of what the slope gains there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crossing {
    pub(crate) position: f64,
    pub(crate) weight: f64,
    pub(crate) line: usize,
}

/// The first crossing, by position and then by line, at which the weights up to it reach `target`; the last one if they never do.
pub(crate) fn select(crossings: &mut [Crossing], target: f64) -> Option<Crossing> {
    let mut range = crossings;
    let mut missing = target;
    while range.len() > 1 {
        let middle = (range.len() - 1) / 2;
        range.select_nth_unstable_by(middle, |a, b| a.position.total_cmp(&b.position).then(a.line.cmp(&b.line)));
        let below: f64 = range[..=middle].iter().map(|c| c.weight).sum();
        if below >= missing {
            range = &mut range[..=middle];
        } else {
            missing -= below;
            range = &mut range[middle + 1..];
        }
    }
    range.first().copied()
}
