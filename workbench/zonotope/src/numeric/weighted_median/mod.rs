//! The weighted median: where weights, added up in the order of their items' places, reach a target.
//!
//! The objective of a least-absolute-deviations problem along a line is convex and changes its slope by a known amount
//! at each crossing, so its minimum is the crossing at which these amounts have made up for the slope at the start.
//!
//! | method | cost for n items | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n log n) | sorts all items: the truth of the tests |
//! | [`by_brackets`] | O(n) expected, little more than a pass | a sample brackets the median, a pass lists what is inside |
//! | [`by_halving`] | O(n) expected | splits what is left at its middle: for few items |
//!
//! The items are two columns, so that a pass reads eight of them at a time.

#[cfg(test)]
mod brute_force;
mod by_brackets;
mod by_halving;

pub(crate) use by_brackets::weighted_median;
