//! One chain of a dynamic hull, by making the list of its vertices anew when an update hits it.
//!
//! # Statement
//! Input: sites, sorted, and which of them are present; insertions and deletions. Output: at any time the chain below
//! or above the present sites, its extreme vertex in a direction, the tangents from a point
//! ([`HullChain`](super::HullChain)). No three vertices are on a line; equal sites are one vertex, which has the lowest
//! index of those present; sites that share an abscissa are in the order of their ordinates. No sites have an empty
//! chain.
//!
//! # Source
//! None: what is done without a structure. Van der Hoog, Reinstädtler and Rotenberg (arXiv 2604.00271) measure their
//! methods beside the like.
//!
//! # Method
//! 1. An inserted site that is inside of the chain, and a deleted one that is no vertex, change nothing.
//! 2. After any other update the vertices are found anew from all present sites, which are sorted: Andrew's scan.
//! 3. A query halves the list of vertices.
//!
//! # Complexity
//! n sites, h vertices: an update that misses the chain O(log h), any other O(n); a query O(log h). Of n random points
//! in a square a random update hits the chain with a probability of O(log n / n); of points of a circle always. Space 4
//! bytes a vertex beside the sorted sites.
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
//! use zonotope::arrangement::dynamic_hull::{Chain, by_rebuilding::Rebuilding};
//! use zonotope::arrangement::dynamic_hull::{HullChain, PlanarPoint, Side, SiteIndex, SortedSites};
//! let points = PlanarPoint::list(&[[0.0, 0.0], [1.0, -1.0], [2.0, 0.0], [1.0, 5.0]])?;
//! let sites = Arc::new(SortedSites::new(&points)?);
//! let mut chain = Chain::<_, Rebuilding>::new(sites, Side::Lower, (0..4).map(SiteIndex))?;
//! assert_eq!(chain.vertices(), [0, 1, 2].map(SiteIndex));
//! chain.delete(SiteIndex(1))?;
//! assert_eq!(chain.vertices(), [0, 2].map(SiteIndex));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::chain::{ChainMethod, LocationTangent, PresentSites};
use super::interface::Towards;
use super::sites::{Direction, Site};
use super::sorted_chain::SortedChain;

/// The vertices of the chain.
#[derive(Debug, Clone)]
pub struct Rebuilding {
    chain: SortedChain,
}

impl<S: Site> ChainMethod<S> for Rebuilding {
    fn build(sites: &PresentSites<S>) -> Self {
        Self { chain: SortedChain::of_ascending(sites, sites.locations()) }
    }

    fn occupy(&mut self, sites: &PresentSites<S>, location: u32) {
        if self.chain.is_outside(sites, location) {
            *self = Self::build(sites);
        }
    }

    fn vacate(&mut self, sites: &PresentSites<S>, location: u32) {
        if self.chain.position(location).is_ok() {
            *self = Self::build(sites);
        }
    }

    fn extreme(&self, sites: &PresentSites<S>, direction: Direction) -> Option<u32> {
        self.chain.extreme(sites, direction)
    }

    fn tangent(&self, sites: &PresentSites<S>, from: &S, towards: Towards) -> LocationTangent {
        self.chain.tangent(sites, from, towards)
    }

    fn vertices(&self, _: &PresentSites<S>) -> Vec<u32> {
        self.chain.vertices().to_vec()
    }

    fn bytes(&self) -> usize {
        self.chain.bytes()
    }
}
