//! A set of positions, with the next member at or after a position: bits in words, and a bit for each word that is not
//! empty, level upon level.

const WORD: usize = u64::BITS as usize;

/// A set of positions below a bound. Space: a bit a position and 1/63 of that.
#[derive(Debug, Clone)]
pub(crate) struct Presence {
    /// Bit k of level l + 1 says whether word k of level l is not zero; the last level is one word.
    levels: Vec<Vec<u64>>,
    len: usize,
}

impl Presence {
    /// The empty set of positions below `bound`. O(bound).
    pub(crate) fn new(bound: usize) -> Self {
        let mut levels = Vec::new();
        let mut words = bound.div_ceil(WORD).max(1);
        levels.push(vec![0; words]);
        while words > 1 {
            words = words.div_ceil(WORD);
            levels.push(vec![0; words]);
        }
        Self { levels, len: 0 }
    }

    /// How many members there are.
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// Whether a position is a member.
    #[inline]
    pub(crate) fn contains(&self, position: usize) -> bool {
        self.levels[0][position / WORD] >> (position % WORD) & 1 == 1
    }

    /// Makes a position a member; whether it was none before. O(log bound).
    pub(crate) fn insert(&mut self, mut position: usize) -> bool {
        if self.contains(position) {
            return false;
        }
        self.len += 1;
        for level in &mut self.levels {
            let word = &mut level[position / WORD];
            let was_empty = *word == 0;
            *word |= 1 << (position % WORD);
            if !was_empty {
                break;
            }
            position /= WORD;
        }
        true
    }

    /// Makes a position no member; whether it was one before. O(log bound).
    pub(crate) fn remove(&mut self, mut position: usize) -> bool {
        if !self.contains(position) {
            return false;
        }
        self.len -= 1;
        for level in &mut self.levels {
            let word = &mut level[position / WORD];
            *word &= !(1 << (position % WORD));
            if *word != 0 {
                break;
            }
            position /= WORD;
        }
        true
    }

    /// The least member that is not below a position. O(log bound).
    #[inline]
    pub(crate) fn next(&self, position: usize) -> Option<usize> {
        let (mut level, mut at) = (0, position);
        loop {
            let words = self.levels.get(level)?;
            let rest = words.get(at / WORD).map_or(0, |word| word & (u64::MAX << (at % WORD)));
            if rest != 0 {
                at = at / WORD * WORD + rest.trailing_zeros() as usize;
                break;
            }
            at = at / WORD + 1;
            level += 1;
        }
        for words in self.levels[..level].iter().rev() {
            at = at * WORD + words[at].trailing_zeros() as usize;
        }
        Some(at)
    }

    /// The members that are not below a position, ascending.
    pub(crate) fn members_from(&self, position: usize) -> impl Iterator<Item = usize> {
        let mut next = self.next(position);
        std::iter::from_fn(move || {
            let found = next?;
            next = self.next(found + 1);
            Some(found)
        })
    }

    /// How many bytes are held.
    pub(crate) fn bytes(&self) -> usize {
        self.levels.iter().map(|words| words.capacity() * size_of::<u64>()).sum()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use proptest::prelude::*;

    properties! {
        #[test]
        fn agrees_with_a_sorted_set(
            bound in 0usize..9000,
            steps in proptest::collection::vec((any::<usize>(), any::<bool>()), 0..60),
        ) {
            let (mut presence, mut truth) = (Presence::new(bound), BTreeSet::new());
            for (position, is_insertion) in steps {
                let position = position % bound.max(1);
                if bound == 0 {
                    break;
                }
                if is_insertion {
                    prop_assert_eq!(presence.insert(position), truth.insert(position));
                } else {
                    prop_assert_eq!(presence.remove(position), truth.remove(&position));
                }
                let from = position / 2;
                prop_assert_eq!(presence.next(from), truth.range(from..).next().copied());
                prop_assert_eq!(presence.contains(from), truth.contains(&from));
                prop_assert_eq!(presence.len(), truth.len());
                prop_assert!(presence.members_from(from).eq(truth.range(from..).copied()));
            }
            prop_assert_eq!(presence.next(bound + 70), None);
        }
    }
}
