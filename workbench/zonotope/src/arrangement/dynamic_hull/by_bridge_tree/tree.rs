//! A complete binary tree over the locations, with a bridge at each node.

use std::ops::RangeInclusive;

/// No location: the part on that side has no site.
pub(super) const VACANT: u32 = u32::MAX;

/// The bridges of the parts of the sites.
///
/// Node 1 is the root, the children of node k are 2k and 2k + 1, the leaf of location l is `leaves` + l.
#[derive(Debug, Clone)]
pub(in crate::arrangement::dynamic_hull) struct BridgeTree {
    /// A power of two, not below the number of locations.
    pub(super) leaves: usize,
    /// By node, below `leaves`: the ends of the bridge between the left and the right part. Where one part is empty its
    /// end is [`VACANT`] and the other end any location.
    pub(super) bridges: Vec<[u32; 2]>,
}

/// The locations from the first to the last, both included, among which the answer of a search is known to be.
pub(super) type Range = RangeInclusive<u32>;

/// All locations.
pub(super) const EVERYWHERE: Range = 0..=VACANT;

/// What a search meets on its way down.
pub(super) enum Node {
    /// A node with two occupied parts.
    Bridge([u32; 2]),
    /// A location.
    Leaf(u32),
}

impl BridgeTree {
    /// The tree of no sites.
    pub(super) fn vacant(locations: usize) -> Self {
        let leaves = locations.next_power_of_two();
        Self { leaves, bridges: vec![[VACANT; 2]; leaves] }
    }

    /// The node itself, or the highest one below it that is a leaf or has two occupied parts; the node is occupied.
    #[inline]
    pub(super) fn descend(&self, node: &mut usize) -> Node {
        loop {
            if *node >= self.leaves {
                return Node::Leaf((*node - self.leaves) as u32);
            }
            match self.bridges[*node] {
                [_, VACANT] => *node = Self::left(*node),
                [VACANT, _] => *node = Self::right(*node),
                bridge => return Node::Bridge(bridge),
            }
        }
    }

    /// The node below which a search for a location in a range has something to decide, or the leaf of its answer.
    #[inline]
    pub(super) fn descend_within(&self, node: &mut usize, range: &Range) -> Node {
        loop {
            match self.descend(node) {
                Node::Bridge([_, q]) if q <= *range.start() => *node = Self::right(*node),
                Node::Bridge([p, _]) if p >= *range.end() => *node = Self::left(*node),
                found => return found,
            }
        }
    }

    #[inline]
    pub(super) fn left(node: usize) -> usize {
        2 * node
    }

    #[inline]
    pub(super) fn right(node: usize) -> usize {
        2 * node + 1
    }

    /// The first location of the right part of a node, occupied or not.
    pub(super) fn boundary(&self, node: usize) -> u32 {
        let right = Self::right(node);
        ((right << (self.leaves.ilog2() - right.ilog2())) - self.leaves) as u32
    }
}
