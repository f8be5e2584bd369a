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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_that_change_their_order_are_counted_one_by_one() {
        let mut state = 3_u64;
        let mut next = |bound: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % bound
        };
        for count in 0..40 {
            let items: Vec<usize> = (0..count).map(|_| next(10)).collect();
            let after = |at: usize| items[at + 1..].iter().filter(|&&later| later < items[at]).count() as u64;
            let expected: u64 = (0..count).map(after).sum();
            let mut sorted = items.clone();
            assert_eq!(sort_counting(&mut sorted, &usize::cmp), expected, "{items:?}");
            assert!(sorted.is_sorted());
        }
    }

    /// A sort of a million items has room for them twice, not for all their pairs.
    #[test]
    fn every_pair_of_a_million_items_in_descending_order_changes() {
        let count = 1_000_000;
        let mut items: Vec<usize> = (0..count).rev().collect();
        let pairs = (count * (count - 1) / 2) as u64;
        assert_eq!(sort_counting(&mut items, &usize::cmp), pairs);
        assert!(items.is_sorted());
    }
}
