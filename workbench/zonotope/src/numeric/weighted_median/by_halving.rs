//! The weighted median by splitting what is left at its middle and adding up one half.

use std::cmp::Ordering;

/// Number of items up to which they are sorted and added up one by one.
const SORT_LIMIT: usize = 20;

/// An item: its place, its weight, and its index in the list that the question is about.
#[derive(Debug, Clone, Copy)]
pub(super) struct Item {
    place: f64,
    weight: f64,
    index: u32,
}

impl Item {
    /// An item whose place is not NaN.
    #[inline]
    pub(super) fn new(place: f64, weight: f64, index: u32) -> Self {
        // the sum makes one zero of two, so that a total order of doubles is that of the places
        Self { place: place + 0.0, weight, index }
    }

    /// By place, and by index where places are equal.
    #[inline]
    fn order(&self, other: &Self) -> Ordering {
        self.place.total_cmp(&other.place).then(self.index.cmp(&other.index))
    }
}

/// The index of the first item at which the weights up to it and with it reach the target, or of the last one; `None`
/// of no items. Leaves the items in another order.
pub(super) fn weighted_median(items: &mut [Item], target: f64) -> Option<usize> {
    let (mut range, mut missing) = (items, target);
    while range.len() > SORT_LIMIT {
        let middle = (range.len() - 1) / 2;
        range.select_nth_unstable_by(middle, Item::order);
        let below: f64 = range[..=middle].iter().map(|item| item.weight).sum();
        if below >= missing {
            range = &mut range[..=middle];
        } else {
            missing -= below;
            range = &mut range[middle + 1..];
        }
    }
    range.sort_unstable_by(Item::order);
    let mut sum = 0.0;
    let reached = range.iter().find(|item| {
        sum += item.weight;
        sum >= missing
    });
    reached.or(range.last()).map(|item| item.index as usize)
}
