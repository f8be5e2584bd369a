//! One chain of a dynamic hull, by the logarithmic method over chains that know deletions only.
//!
//! # Statement
//! Input: sites, sorted, and which of them are present; insertions and deletions. Output: at any time the chain below
//! or above the present sites, its extreme vertex in a direction, the tangents from a point
//! ([`HullChain`](super::HullChain)). No three vertices are on a line; equal sites are one vertex, which has the lowest
//! index of those present; sites that share an abscissa are in the order of their ordinates. No sites have an empty
//! chain.
//!
//! # Source
//! Bentley and Saxe, Decomposable searching problems, J. Algorithms 1 (1980) 301; for hulls see van der Hoog,
//! Reinstädtler and Rotenberg, arXiv 2604.00271. Departure: a deletion scans the members of the block between the
//! neighbours of the site, without a structure that finds the new vertices among them faster.
//!
//! # Method
//! 1. The present sites are in blocks, at most 2^k of them in the block of level k, each with the list of its vertices.
//! 2. An insertion joins the site and the blocks of the lowest levels, up to the first empty one, in one block.
//! 3. A deletion of a vertex of a block puts the chain of the block's sites between its neighbours in its place.
//! 4. The extreme vertex is the best of the blocks' ones. So is a tangent, unless the tangents to both sides have the
//!    point strictly inside of the line through the sites that they touch.
//!
//! # Complexity
//! n sites: an insertion O(log n) amortised; a deletion O(log n) where few sites are between the neighbours of the
//! site, O(n) at worst; a query O(log² n); the vertices O(h log n) for chains of h vertices in all blocks. Space up to
//! 17 bytes a site beside the sorted sites.
//!
//! # Shapes
//! `sites`: n points or lines in any order, duplicates allowed ([`SortedSites`](super::SortedSites)); `present`:
//! indices in any order, none twice.
//!
//! # Numerics
//! All decisions are exact: doubles with a bound on their error, exact binary numbers where that leaves a doubt. No
//! coordinate is rounded.
//!
//! # Errors
//! [`UpdateError::Present`](super::UpdateError::Present) ⇔ a site is inserted that is there;
//! [`UpdateError::Absent`](super::UpdateError::Absent) ⇔ one is deleted that is not there;
//! [`UpdateError::Unknown`](super::UpdateError::Unknown) ⇔ the index is not below the number of sites.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on all families, and the other methods on large ones.
//!
//! # Example
//! ```
//! use std::sync::Arc;
//! use zonotope::arrangement::dynamic_hull::{Chain, by_logarithmic_method::Logarithmic};
//! use zonotope::arrangement::dynamic_hull::{HullChain, PlanarPoint, Side, SiteIndex, SortedSites};
//! let points = PlanarPoint::list(&[[0.0, 0.0], [1.0, -1.0], [2.0, 0.0], [1.0, 5.0]])?;
//! let sites = Arc::new(SortedSites::new(&points)?);
//! let mut chain = Chain::<_, Logarithmic>::new(sites, Side::Lower, (0..4).map(SiteIndex))?;
//! assert_eq!(chain.vertices(), [0, 1, 2].map(SiteIndex));
//! chain.delete(SiteIndex(1))?;
//! assert_eq!(chain.vertices(), [0, 2].map(SiteIndex));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod block;

use super::chain::{ChainMethod, LocationTangent, PresentSites};
use super::descent::{Step, extreme_step};
use super::interface::Towards;
use super::sites::{Direction, Site};
use super::sorted_chain::SortedChain;
use crate::numeric::orientation::Turn;
use block::Block;

/// The level of a location that is not occupied.
const VACANT: u8 = u8::MAX;

/// The blocks by level, and the level of each location.
#[derive(Debug, Clone)]
pub struct Logarithmic {
    /// The block of level k has at most 2^k locations, those that have left it included.
    blocks: Vec<Block>,
    /// By location.
    levels: Vec<u8>,
}

impl Logarithmic {
    /// Makes the block of a level of locations that ascend.
    fn fill<S: Site>(&mut self, sites: &PresentSites<S>, members: Vec<u32>) {
        let level = members.len().next_power_of_two().ilog2() as usize;
        for &member in &members {
            self.levels[member as usize] = level as u8;
        }
        if self.blocks.len() <= level {
            self.blocks.resize_with(level + 1, Block::default);
        }
        self.blocks[level] = Block::new(sites, members);
    }

    /// Of two locations on one side of a point, the one that the tangent from the point touches.
    fn outer<S: Site>(sites: &PresentSites<S>, from: &S, towards: Towards, [a, b]: [u32; 2]) -> u32 {
        let (turn, farther) = match towards {
            Towards::Left => (S::turn(sites.point(a), from, sites.point(b)), a.min(b)),
            Towards::Right => (S::turn(from, sites.point(a), sites.point(b)), a.max(b)),
        };
        match turn {
            Turn::Straight => farther,
            turn if turn == sites.side.outward() => b,
            _ => a,
        }
    }

    /// The tangent to all blocks, as if there were only the sites on that side.
    fn one_sided<S: Site>(&self, sites: &PresentSites<S>, from: &S, towards: Towards) -> LocationTangent {
        let mut found = None;
        for block in &self.blocks {
            match block.chain.tangent(sites, from, towards) {
                LocationTangent::Touches(location) => {
                    found = Some(found.map_or(location, |best| Self::outer(sites, from, towards, [best, location])));
                }
                LocationTangent::Hidden => return LocationTangent::Hidden,
                LocationTangent::Unbounded => {}
            }
        }
        found.map_or(LocationTangent::Unbounded, LocationTangent::Touches)
    }
}

impl<S: Site> ChainMethod<S> for Logarithmic {
    fn build(sites: &PresentSites<S>) -> Self {
        let mut method = Self { blocks: Vec::new(), levels: vec![VACANT; sites.sites.location_count()] };
        let members: Vec<u32> = sites.locations().collect();
        if !members.is_empty() {
            method.fill(sites, members);
        }
        method
    }

    fn occupy(&mut self, sites: &PresentSites<S>, location: u32) {
        let mut members = vec![location];
        for (level, block) in self.blocks.iter_mut().enumerate().take_while(|(_, block)| !block.is_empty()) {
            let levels = &self.levels;
            let stayed = |&member: &u32| usize::from(levels[member as usize]) == level;
            members.extend(std::mem::take(block).into_members().into_iter().filter(stayed));
        }
        // runs that ascend, which a stable sort merges
        members.sort();
        self.fill(sites, members);
    }

    fn vacate(&mut self, sites: &PresentSites<S>, location: u32) {
        let level = std::mem::replace(&mut self.levels[location as usize], VACANT);
        let levels = &self.levels;
        self.blocks[usize::from(level)].delete(sites, location, |member| levels[member as usize] != level);
    }

    fn extreme(&self, sites: &PresentSites<S>, direction: Direction) -> Option<u32> {
        let each = self.blocks.iter().filter_map(|block| block.chain.extreme(sites, direction));
        each.reduce(|best, other| {
            let edge = [best.min(other), best.max(other)];
            match extreme_step(sites.side, edge.map(|location| sites.point(location)), direction) {
                Step::Right => edge[1],
                _ => edge[0],
            }
        })
    }

    fn tangent(&self, sites: &PresentSites<S>, from: &S, towards: Towards) -> LocationTangent {
        let found = self.one_sided(sites, from, towards);
        let other = match towards {
            Towards::Left => self.one_sided(sites, from, Towards::Right),
            Towards::Right => self.one_sided(sites, from, Towards::Left),
        };
        let (LocationTangent::Touches(a), LocationTangent::Touches(b)) = (found, other) else { return found };
        let [left, right] = [a.min(b), a.max(b)].map(|location| sites.point(location));
        let is_inside = S::turn(left, right, from) == sites.side.outward().reverse();
        if is_inside { LocationTangent::Hidden } else { found }
    }

    fn vertices(&self, sites: &PresentSites<S>) -> Vec<u32> {
        let mut vertices: Vec<u32> = self.blocks.iter().flat_map(|block| block.chain.vertices()).copied().collect();
        vertices.sort();
        SortedChain::of_ascending(sites, vertices.into_iter()).vertices().to_vec()
    }

    fn bytes(&self) -> usize {
        self.levels.capacity() + self.blocks.iter().map(Block::bytes).sum::<usize>()
    }
}
