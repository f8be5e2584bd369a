//! A chain from which sites are deleted, and into which none is inserted.

use crate::arrangement::dynamic_hull::chain::PresentSites;
use crate::arrangement::dynamic_hull::sites::Site;
use crate::arrangement::dynamic_hull::sorted_chain::SortedChain;

/// Some locations, and the chain of those that have not left.
#[derive(Debug, Clone, Default)]
pub(super) struct Block {
    /// The locations that the block was made of, ascending.
    members: Vec<u32>,
    pub(super) chain: SortedChain,
}

impl Block {
    /// The block of locations that ascend. O(n).
    pub(super) fn new<S: Site>(sites: &PresentSites<S>, members: Vec<u32>) -> Self {
        let chain = SortedChain::of_ascending(sites, members.iter().copied());
        Self { members, chain }
    }

    /// Whether the block was made of nothing.
    pub(super) fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// The locations that the block was made of.
    pub(super) fn into_members(self) -> Vec<u32> {
        self.members
    }

    /// Takes a location off the chain: between its neighbours, what was hidden behind it comes forth.
    pub(super) fn delete<S: Site>(&mut self, sites: &PresentSites<S>, location: u32, has_left: impl Fn(u32) -> bool) {
        let Ok(position) = self.chain.position(location) else { return };
        let vertices = self.chain.vertices();
        let before = position.saturating_sub(1);
        let after = (position + 1).min(vertices.len() - 1);
        // past an end of the chain there may be others, as far as the members go
        let start = if before < position { self.members.partition_point(|&m| m < vertices[before]) } else { 0 };
        let end = match after > position {
            true => self.members.partition_point(|&m| m <= vertices[after]),
            false => self.members.len(),
        };
        let left = self.members[start..end].iter().copied().filter(|&member| !has_left(member));
        let between = SortedChain::of_ascending(sites, left);
        self.chain.replace(before..after + 1, between.vertices());
    }

    /// How many bytes are held.
    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>() + self.members.capacity() * size_of::<u32>() + self.chain.bytes()
    }
}
