//! Inversions of a sequence: counted, listed, or picked by rank, in one merge sort.
//!
//! An inversion is a pair of elements of which the first is the greater. When a merge takes an element of its right
//! run, that element is inverted with all that is left of the left run, and every inversion is seen so exactly once.

use crate::tally::{Operation, Tally};

/// The number of inversions. Sorts the sequence. O(n log n).
pub(super) fn count(sequence: &mut Vec<u32>, tally: &mut impl Tally) -> u64 {
    let mut total = 0;
    merge_sort(sequence, tally, |greater, _| total += greater.len() as u64);
    total
}

/// All inversions, k of them. Sorts the sequence. O(n log n + k).
pub(super) fn list(sequence: &mut Vec<u32>, tally: &mut impl Tally) -> Vec<[u32; 2]> {
    let mut pairs = Vec::new();
    merge_sort(sequence, tally, |greater, less| pairs.extend(greater.iter().map(|&g| [g, less])));
    pairs
}

/// The inversions with the given ranks, which ascend, in the order in which the merges meet them. Sorts the sequence.
/// O(n log n) for n ranks.
pub(super) fn pick(
    sequence: &mut Vec<u32>,
    ranks: impl IntoIterator<Item = u64>,
    tally: &mut impl Tally,
) -> Vec<[u32; 2]> {
    let mut ranks = ranks.into_iter().peekable();
    let mut passed = 0;
    let mut pairs = Vec::new();
    merge_sort(sequence, tally, |greater, less| {
        let end = passed + greater.len() as u64;
        while let Some(rank) = ranks.next_if(|&rank| rank < end) {
            pairs.push([greater[(rank - passed) as usize], less]);
        }
        passed = end;
    });
    pairs
}

/// Sorts the sequence; `visit` sees each element of a right run with the greater elements of the left run, if any.
fn merge_sort(sequence: &mut Vec<u32>, tally: &mut impl Tally, mut visit: impl FnMut(&[u32], u32)) {
    let mut merged = vec![0; sequence.len()];
    let mut comparisons = 0;
    let mut width = 1;
    while width < sequence.len() {
        for (runs, target) in sequence.chunks(2 * width).zip(merged.chunks_mut(2 * width)) {
            let (left, right) = runs.split_at(width.min(runs.len()));
            comparisons += merge(left, right, target, &mut visit);
        }
        std::mem::swap(sequence, &mut merged);
        width *= 2;
    }
    tally.add(Operation::Comparison, comparisons);
}

/// Merges two runs; returns the number of comparisons.
fn merge(left: &[u32], right: &[u32], target: &mut [u32], visit: &mut impl FnMut(&[u32], u32)) -> u64 {
    let (mut i, mut j) = (0, 0);
    while i < left.len() && j < right.len() {
        if right[j] < left[i] {
            visit(&left[i..], right[j]);
            target[i + j] = right[j];
            j += 1;
        } else {
            target[i + j] = left[i];
            i += 1;
        }
    }
    let taken = i + j;
    target[taken..taken + left.len() - i].copy_from_slice(&left[i..]);
    target[taken + left.len() - i..].copy_from_slice(&right[j..]);
    taken as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    properties! {
        #[test]
        fn agree_with_all_pairs(sequence in proptest::collection::vec(0u32..40, 0..60)) {
            let pairs = sequence.iter().enumerate().flat_map(|(i, &a)| sequence[i..].iter().map(move |&b| [a, b]));
            let mut truth: Vec<_> = pairs.filter(|[a, b]| a > b).collect();
            prop_assert_eq!(count(&mut sequence.clone(), &mut ()), truth.len() as u64);
            let listed = list(&mut sequence.clone(), &mut ());
            let every_other = || (0..truth.len() as u64).step_by(2);
            let picked = pick(&mut sequence.clone(), every_other(), &mut ());
            prop_assert!(picked.iter().eq(listed.iter().step_by(2)));
            let mut listed = listed;
            listed.sort_unstable();
            truth.sort_unstable();
            prop_assert_eq!(listed, truth);
        }
    }
}
