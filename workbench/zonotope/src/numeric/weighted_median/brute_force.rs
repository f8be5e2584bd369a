//! The weighted median by sorting all items: the truth.

/// The index of the first item, by place and then by index, at which the weights up to it and with it reach the target;
/// that of the last one if they never do. O(n log n).
pub(crate) fn weighted_median(places: &[f64], weights: &[f64], target: f64) -> Option<usize> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|&i, &j| places[i].partial_cmp(&places[j]).expect("no place is NaN"));
    let mut sum = 0.0;
    let reached = order.iter().position(|&i| {
        sum += weights[i];
        sum >= target
    });
    reached.map_or(order.last(), |rank| order.get(rank)).copied()
}
