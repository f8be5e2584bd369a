//! Sorting by exact fractions at the speed of doubles.
//!
//! Items are sorted by the leading double of their approximate keys. Where the intervals that hold the exact keys
//! overlap, the items form a cluster, and each cluster is sorted again: by the approximations where they are certain,
//! by the exact fractions where they are not. The result is the exact order whatever the approximations are.

use std::cell::{Cell, OnceCell};
use std::cmp::Ordering;
use std::ops::Range;

use super::fraction::Fraction;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::tally::{Operation, Tally};

/// An item with its approximate key.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Keyed {
    pub(crate) key: BoundedDoubleDouble,
    pub(crate) item: u32,
}

/// Sorts by exact key, and by item where keys are equal; returns the ranges, longer than one, of equal keys.
pub(crate) fn sort_exactly(
    items: &mut [Keyed],
    exact: impl Fn(u32) -> Fraction,
    tally: &mut impl Tally,
) -> Vec<Range<usize>> {
    let counts = Counts::default();
    items.sort_unstable_by(|a, b| {
        counts.comparisons.set(counts.comparisons.get() + 1);
        a.key.high.total_cmp(&b.key.high)
    });
    let mut ties = Vec::new();
    for cluster in clusters(items) {
        sort_cluster(items, cluster, &exact, &counts, &mut ties);
    }
    tally.add(Operation::Comparison, counts.comparisons.get());
    tally.add(Operation::ExactFallback, counts.exact.get());
    ties
}

#[derive(Default)]
struct Counts {
    comparisons: Cell<u64>,
    exact: Cell<u64>,
}

/// The ranges, longer than one, outside of which every item is certainly below or above all of the range.
fn clusters(items: &[Keyed]) -> Vec<Range<usize>> {
    let mut least_from: Vec<f64> = items.iter().map(|item| item.key.interval().0).collect();
    for i in (1..least_from.len()).rev() {
        least_from[i - 1] = least_from[i - 1].min(least_from[i]);
    }
    let mut clusters = Vec::new();
    let (mut start, mut greatest) = (0, f64::NEG_INFINITY);
    for (i, item) in items.iter().enumerate() {
        greatest = greatest.max(item.key.interval().1);
        let next = i + 1;
        if next == items.len() || greatest < least_from[next] {
            if next - start > 1 {
                clusters.push(start..next);
            }
            start = next;
        }
    }
    clusters
}

fn sort_cluster(
    items: &mut [Keyed],
    cluster: Range<usize>,
    exact: &impl Fn(u32) -> Fraction,
    counts: &Counts,
    ties: &mut Vec<Range<usize>>,
) {
    let members = items[cluster.clone()].to_vec();
    let fractions: Vec<OnceCell<Fraction>> = vec![OnceCell::new(); members.len()];
    let fraction = |i: u32| fractions[i as usize].get_or_init(|| exact(members[i as usize].item));
    let order = |&a: &u32, &b: &u32| {
        counts.comparisons.set(counts.comparisons.get() + 1);
        members[a as usize].key.certain_order(&members[b as usize].key).unwrap_or_else(|| {
            counts.exact.set(counts.exact.get() + 1);
            fraction(a).cmp(fraction(b))
        })
    };
    let mut sorted: Vec<u32> = (0..members.len() as u32).collect();
    sorted.sort_unstable_by(order);
    for (place, &i) in items[cluster.clone()].iter_mut().zip(&sorted) {
        *place = members[i as usize];
    }
    let mut start = 0;
    for next in 1..=sorted.len() {
        if next < sorted.len() && order(&sorted[next - 1], &sorted[next]) == Ordering::Equal {
            continue;
        }
        if next - start > 1 {
            let tie = cluster.start + start..cluster.start + next;
            items[tie.clone()].sort_unstable_by_key(|keyed| keyed.item);
            ties.push(tie);
        }
        start = next;
    }
}
