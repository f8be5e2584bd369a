//! Sets of points as bits, and the order of sets in the reflected binary code, in which neighbours differ by few
//! points.

/// A set of points given by their places, one bit each.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct PointSet(Vec<u64>);

impl PointSet {
    /// The empty set, with room for points at places below a count.
    pub(super) fn with_room_for(count: usize) -> Self {
        Self(vec![0; count.div_ceil(64)])
    }

    /// Makes room for one more point, at the place `count`.
    pub(super) fn make_room(&mut self, count: usize) {
        if count.is_multiple_of(64) {
            self.0.push(0);
        }
    }

    pub(super) fn insert(&mut self, point: usize) {
        self.0[point / 64] |= 1 << (point % 64);
    }

    pub(super) fn contains(&self, point: usize) -> bool {
        self.0[point / 64] >> (point % 64) & 1 == 1
    }

    /// The number of points in the set.
    pub(super) fn count(&self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }

    pub(super) fn is_single(&self) -> bool {
        self.count() == 1
    }

    /// The points of the set in increasing order.
    pub(super) fn members(&self) -> impl Iterator<Item = usize> {
        places_of_bits(self.0.iter().copied())
    }

    /// The points by which this set and the one before it differ, in increasing order, each with whether it belongs to
    /// this one.
    pub(super) fn changes_since(&self, before: &Self) -> impl Iterator<Item = (usize, bool)> {
        let changed = self.0.iter().zip(&before.0).map(|(a, b)| a ^ b);
        places_of_bits(changed).map(|point| (point, self.contains(point)))
    }

    /// The rank of the set among all sets in the reflected binary code (Gray code), in which neighbours differ by one
    /// point.
    pub(super) fn rank_in_code(&self) -> Vec<u64> {
        let mut is_reflected = false;
        let decoded = self.0.iter().map(|&word| {
            let mut rank = word;
            for shift in [1, 2, 4, 8, 16, 32] {
                rank ^= rank >> shift;
            }
            if is_reflected {
                rank = !rank;
            }
            is_reflected = rank & 1 == 1;
            rank
        });
        decoded.collect()
    }
}

/// The places of the ones among the bits of some words, in increasing order.
fn places_of_bits(words: impl Iterator<Item = u64>) -> impl Iterator<Item = usize> {
    words.enumerate().flat_map(|(word, bits)| {
        let next = |&left: &u64| (left & (left - 1) != 0).then_some(left & left.wrapping_sub(1));
        let first = (bits != 0).then_some(bits);
        std::iter::successors(first, next).map(move |left| 64 * word + left.trailing_zeros() as usize)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_code_passes_all_sets_one_point_at_a_time() {
        // All sets of the points 0, 63 and 64, which lie in two words.
        let points = [0, 63, 64];
        let mut sets: Vec<PointSet> = (0..8)
            .map(|choice| {
                let mut set = PointSet::with_room_for(65);
                points.iter().enumerate().filter(|(i, _)| choice >> i & 1 == 1).for_each(|(_, &p)| set.insert(p));
                set
            })
            .collect();
        sets.sort_by_cached_key(PointSet::rank_in_code);
        for pair in sets.windows(2) {
            assert_eq!(pair[1].changes_since(&pair[0]).count(), 1);
        }
        assert_eq!(PointSet(vec![1 << 63 | 1, 1]).members().collect::<Vec<_>>(), points);
        assert_eq!(PointSet(vec![6]).changes_since(&PointSet(vec![3])).collect::<Vec<_>>(), [(0, false), (2, true)]);
    }
}
