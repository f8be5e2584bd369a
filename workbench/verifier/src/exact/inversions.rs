//! The number of pairs that a sort brings into another order.

use std::cmp::Ordering;

/// Sorts stably and counts the pairs whose order changes.
pub(crate) fn sort_counting(items: &mut [usize], compare: &impl Fn(&usize, &usize) -> Ordering) -> u64 {
    if items.len() < 2 {
        return 0;
    }
    let (first, second) = items.split_at_mut(items.len() / 2);
    let mut count = sort_counting(first, compare) + sort_counting(second, compare);
    let mut merged = Vec::with_capacity(first.len() + second.len());
    let (mut i, mut j) = (0, 0);
    while i < first.len() || j < second.len() {
        let take_second = j < second.len() && (i == first.len() || compare(&first[i], &second[j]) == Ordering::Greater);
        if take_second {
            count += (first.len() - i) as u64;
            merged.push(second[j]);
            j += 1;
        } else {
            merged.push(first[i]);
            i += 1;
        }
    }
    items.copy_from_slice(&merged);
    count
}
