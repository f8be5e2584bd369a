//! Subsets of one size, in lexicographic order: the tuples of generators that span a hyperplane.

/// Calls `visit` with the subsets of 0 … `count` − 1 of one size, in lexicographic order; of size 0 there is one.
pub(crate) fn for_each_subset(count: usize, size: usize, mut visit: impl FnMut(&[usize])) {
    let mut subset: Vec<usize> = (0..size).collect();
    if size > count {
        return;
    }
    loop {
        visit(&subset);
        let Some(at) = (0..size).rev().find(|&at| subset[at] + size < count + at) else { return };
        subset[at] += 1;
        for later in at + 1..size {
            subset[later] = subset[later - 1] + 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_four_and_what_is_empty() {
        let list = |count, size| {
            let mut found = Vec::new();
            for_each_subset(count, size, |subset| found.push(subset.to_vec()));
            found
        };
        assert_eq!(list(4, 2), [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]);
        assert_eq!(list(3, 0), [[0usize; 0]]);
        assert!(list(1, 2).is_empty());
    }

    #[test]
    fn each_subset_comes_once_and_in_order() {
        for (count, size) in (0..7).flat_map(|count| (0..8).map(move |size| (count, size))) {
            let members = |mask: u32| (0..count).filter(|i| mask >> i & 1 == 1).collect::<Vec<usize>>();
            let mut all: Vec<Vec<usize>> = (0..1 << count).map(members).filter(|subset| subset.len() == size).collect();
            all.sort();
            let mut found = Vec::new();
            for_each_subset(count, size, |subset| found.push(subset.to_vec()));
            assert_eq!(found, all, "{size} of {count}");
        }
    }
}
