//! The subsets of a given size of the first so many numbers.

/// The number of subsets, or the largest number.
pub(crate) fn count_subsets(count: usize, size: usize) -> u64 {
    if size > count {
        return 0;
    }
    (0..size as u64).fold(1_u64, |product, step| product.saturating_mul(count as u64 - step) / (step + 1))
}

/// The subsets in lexicographic order, each ascending.
pub(crate) fn subsets(count: usize, size: usize) -> impl Iterator<Item = Vec<usize>> {
    let first = (size <= count).then(|| (0..size).collect::<Vec<usize>>());
    std::iter::successors(first, move |last| {
        let step = (0..size).rev().find(|&position| last[position] < count - size + position)?;
        let mut next = last.clone();
        next[step] += 1;
        for position in step + 1..size {
            next[position] = next[position - 1] + 1;
        }
        Some(next)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subsets_are_counted_and_listed() {
        let listed: Vec<Vec<usize>> = subsets(4, 2).collect();
        assert_eq!(listed, [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]);
        assert_eq!(subsets(3, 0).collect::<Vec<_>>(), [Vec::<usize>::new()]);
        assert_eq!(subsets(2, 3).count(), 0);
        for (count, size) in [(7, 3), (6, 6), (5, 0), (3, 4)] {
            assert_eq!(subsets(count, size).count() as u64, count_subsets(count, size));
        }
        assert!(count_subsets(2_000_000, 5) > 1_000_000_000, "too many to count is many");
    }
}
