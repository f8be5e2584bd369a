//! Work shared between processes that do not know of each other: which one of them does what.
//!
//! Every process has the same list of pieces of work with their expected costs, deals it in the same way, and does its
//! own hand. The costs are whole numbers, so that the hands are the same on every machine.

mod costs;

pub use costs::nanoseconds_an_element;

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::fmt;
use std::str::FromStr;

/// The most shards of a run.
pub const SHARD_LIMIT: usize = 100_000;

/// A share of some work: number `index`, from 0, of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shard {
    count: usize,
    index: usize,
}

/// Why numbers name no shard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ShardError {
    /// The text is not two numbers.
    #[error("a shard is i/n: its number, from 0, and how many there are, as in 0/16")]
    NotTwoNumbers,
    /// There are no shards, or more than are taken.
    #[error("there are {count} shards; 1 to {SHARD_LIMIT} are taken")]
    Count {
        /// The number of shards.
        count: usize,
    },
    /// The number is that of no shard.
    #[error("there is no shard {index} of {count}: they are numbered from 0 to {}", .count - 1)]
    Index {
        /// The number given.
        index: usize,
        /// The number of shards.
        count: usize,
    },
}

impl Shard {
    /// Shard `index` of `count`.
    ///
    /// # Errors
    /// [`ShardError`] unless `index` is below `count`, which is from 1 to [`SHARD_LIMIT`].
    pub fn new(index: usize, count: usize) -> Result<Self, ShardError> {
        if !(1..=SHARD_LIMIT).contains(&count) {
            return Err(ShardError::Count { count });
        }
        if index >= count {
            return Err(ShardError::Index { index, count });
        }
        Ok(Self { count, index })
    }

    /// The number of the shard, from 0.
    pub fn index(self) -> usize {
        self.index
    }

    /// The number of all shards.
    pub fn count(self) -> usize {
        self.count
    }

    /// Whether each piece of work belongs to this shard, when all are dealt by their expected costs.
    pub fn hand(self, costs: &[u64]) -> Vec<bool> {
        deal(costs, self.count).into_iter().map(|owner| owner == self.index).collect()
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let number = |text: &str| text.parse().map_err(|_| ShardError::NotTwoNumbers);
        let (index, count) = text.split_once('/').ok_or(ShardError::NotTwoNumbers)?;
        Self::new(number(index)?, number(count)?)
    }
}

/// For each piece of work the shard that does it: the costliest pieces first, each to the shard with the least so far
/// (Graham's rule, at most 4/3 of the best division).
fn deal(costs: &[u64], count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..costs.len()).collect();
    order.sort_by_key(|&piece| Reverse(costs[piece]));
    let mut hands: BinaryHeap<Reverse<(u128, usize)>> = (0..count).map(|shard| Reverse((0, shard))).collect();
    let mut owners = vec![0; costs.len()];
    for piece in order {
        if let Some(mut least) = hands.peek_mut() {
            owners[piece] = least.0.1;
            // A piece that costs nothing fills a hand as well, so that no shard gets all of them.
            least.0.0 += u128::from(costs[piece].max(1));
        }
    }
    owners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_are_numbered_from_zero_and_always_counted() {
        let shard: Shard = "3/16".parse().expect("a shard");
        assert_eq!((shard.index(), shard.count(), shard.to_string().as_str()), (3, 16, "3/16"));
        for (text, complaint) in [
            ("3", "a shard is i/n"),
            ("a/4", "a shard is i/n"),
            ("-1/4", "a shard is i/n"),
            ("4/4", "there is no shard 4 of 4: they are numbered from 0 to 3"),
            ("0/0", "there are 0 shards"),
            ("0/100001", "there are 100001 shards; 1 to 100000 are taken"),
        ] {
            let refused = text.parse::<Shard>().expect_err(text).to_string();
            assert!(refused.starts_with(complaint), "{refused}");
        }
    }

    #[test]
    fn every_piece_has_one_owner_and_hands_are_even() {
        let costs: Vec<u64> = (0..1000).map(|piece| (piece * 7919) % 1009).collect();
        for count in [1, 2, 16, 999, 2000] {
            let mut owned = vec![0; costs.len()];
            let mut hands = Vec::new();
            for index in 0..count {
                let hand = Shard::new(index, count).expect("a shard").hand(&costs);
                owned.iter_mut().zip(&hand).for_each(|(times, &mine)| *times += u32::from(mine));
                hands.push(costs.iter().zip(&hand).filter(|(_, mine)| **mine).map(|(cost, _)| cost).sum::<u64>());
            }
            assert!(owned.iter().all(|&times| times == 1), "{count} shards");
            let bound = (costs.iter().sum::<u64>() / count as u64).max(1008) * 4 / 3;
            assert!(hands.iter().all(|&hand| hand <= bound + 1), "{count} shards: {hands:?}");
        }
        let alike: Vec<usize> = deal(&[0; 12], 4);
        assert!((0..4).all(|shard| alike.iter().filter(|&&owner| owner == shard).count() == 3));
    }
}
