//! The weighted median, by selection: where weights, added up in order, reach a target.
//!
//! The objective of a least-absolute-deviations problem along a line is convex and changes its slope by a known amount
//! at each crossing, so its minimum is the crossing at which these amounts have made up for the slope at the start.

use std::cmp::Ordering;

/// The first item, in the given order, at which the weights up to it and with it reach `target`; the last one if they
/// never do; `None` of no items.
///
/// The weights are not negative. Items that the order calls equal are taken in any order, so a total one makes the
/// answer unique. Sums of doubles are rounded, and so is the answer a guess wherever the sum is near the target.
/// Expected O(n), where sorting costs O(n log n): each round splits what is left at its middle and sums up one half.
/// Leaves the items in another order: those before the answer first.
pub(crate) fn weighted_median<T>(
    items: &mut [T],
    target: f64,
    order: impl Fn(&T, &T) -> Ordering,
    weight: impl Fn(&T) -> f64,
) -> Option<&T> {
    let mut range = items;
    let mut missing = target;
    while range.len() > 1 {
        let middle = (range.len() - 1) / 2;
        range.select_nth_unstable_by(middle, &order);
        let below: f64 = range[..=middle].iter().map(&weight).sum();
        if below >= missing {
            range = &mut range[..=middle];
        } else {
            missing -= below;
            range = &mut range[middle + 1..];
        }
    }
    range.first()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn median(items: &[(i32, f64)], target: f64) -> Option<i32> {
        weighted_median(&mut items.to_vec(), target, |a, b| a.0.cmp(&b.0), |item| item.1).map(|item| item.0)
    }

    #[test]
    fn by_hand() {
        let items = [(3, 1.0), (1, 2.0), (2, 4.0)];
        assert_eq!(
            [2.0, 2.5, 6.0, 6.5, 8.0].map(|target| median(&items, target)),
            [Some(1), Some(2), Some(2), Some(3), Some(3)]
        );
        assert_eq!(median(&items, -1.0), Some(1));
        assert_eq!(median(&[], 0.0), None);
    }

    proptest! {
        #[test]
        fn it_is_what_adding_up_in_order_finds(
            weights in proptest::collection::vec(0u8..9, 1..50),
            target in 0u16..300,
        ) {
            // distinct keys in an order other than that of the list
            let items: Vec<(i32, f64)> =
                weights.iter().enumerate().map(|(i, &w)| ((i * 37 % 101) as i32, f64::from(w))).collect();
            let mut sorted = items.clone();
            sorted.sort_unstable_by_key(|item| item.0);
            let mut sum = 0.0;
            let reached = sorted.iter().find(|item| { sum += item.1; sum >= f64::from(target) });
            prop_assert_eq!(median(&items, f64::from(target)), reached.or(sorted.last()).map(|item| item.0));
        }
    }
}
