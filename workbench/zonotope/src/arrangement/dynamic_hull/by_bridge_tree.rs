//! One chain of a dynamic hull, by a tree of bridges over the sorted sites.
//!
//! # Source
//! Lemma 5.6 takes the structure of Overmars and van Leeuwen, Maintenance of configurations in the plane, J. Comput.
//! Syst. Sci. 23 (1981) 166. Departures: all sites are known beforehand, so that the tree is complete and is never
//! rebalanced; a node keeps its bridge alone and no part of a hull, since a search needs no more; of the many cases of
//! their bridge search three are left (Gaede, Gørtz, van der Hoog, Krogh and Rotenberg, arXiv 2310.18068, have a
//! simplification of the same kind).
//!
//! # Method
//! 1. The leaves of a complete binary tree are the distinct points in order. Each node has the bridge of its part of
//!    the sites: the edge of the part's chain that joins the part's left half with its right half.
//! 2. A query goes down from the root: the bridge of a node, an edge of its chain, tells in which half the answer is.
//! 3. The bridge of a node is found by going down in both halves at once (`by_bridge_tree/search.rs`). The sites of one
//!    half's edge that are not inside of the other edge's line tell where that half's end is; if all are inside, the
//!    abscissa where the lines meet does.
//! 4. An insertion goes up from the leaf. A bridge that the new site is outside of is replaced by the tangent from the
//!    site to the other half; every other bridge stays. Where the site is inside of the bridge, it is a vertex of no
//!    larger part, and the way up ends.
//! 5. A deletion goes up likewise, and finds anew the bridges that end in the site. Their ends are looked for where
//!    they can be: between the neighbours of the site on the chain of its own part, and on this side of the old end in
//!    the other part (`by_bridge_tree/search.rs`).
//!
//! # Complexity
//! n sites: an update O(log² n), a query O(log n), the paper's bounds; construction O(n) after sorting. On average a
//! site is an end of less than two bridges, whatever the sites are, so the update of a random one is O(log n) expected.
//! Space 8 to 16 bytes a site beside the sorted sites.
//!
//! # Numerics
//! All decisions are exact: doubles with a bound on their error, exact binary numbers where that leaves a doubt. No
//! coordinate is rounded.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on all families, and static hulls of large sets.
//!
//! # Example
//! ```
//! use std::sync::Arc;
//! use zonotope::arrangement::dynamic_hull::{DynamicChain, HullChain, PlanarPoint, Side, SiteIndex, SortedSites};
//! let points = PlanarPoint::list(&[[0.0, 0.0], [1.0, -1.0], [2.0, 0.0], [1.0, 5.0]])?;
//! let sites = Arc::new(SortedSites::new(&points)?);
//! let mut chain = DynamicChain::new(sites, Side::Lower, (0..4).map(SiteIndex))?;
//! assert_eq!(chain.vertices(), [0, 1, 2].map(SiteIndex));
//! chain.delete(SiteIndex(1))?;
//! assert_eq!(chain.vertices(), [0, 2].map(SiteIndex));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod search;
mod tree;

pub(super) use tree::BridgeTree;

use super::descent::{Step, extreme_step, tangent_step, tangent_to_site};
use super::interface::Towards;
use super::present_sites::{LocationTangent, PresentSites};
use super::sites::{Direction, Site};
use crate::numeric::orientation::Turn;
use search::{bridge, touching};
use tree::{EVERYWHERE, Node, Range, VACANT};

impl BridgeTree {
    /// The root, if a site is present.
    fn root<S: Site>(&self, sites: &PresentSites<S>) -> Option<usize> {
        let is_occupied = if self.leaves > 1 { self.bridges[1] != [VACANT; 2] } else { sites.has_any() };
        is_occupied.then_some(1)
    }

    /// Finds the bridge of a node anew, with its ends in ranges; both of its parts are occupied.
    fn renew<S: Site>(&mut self, sites: &PresentSites<S>, node: usize, ranges: [Range; 2]) {
        let parts = [Self::left(node), Self::right(node)];
        self.bridges[node] = bridge(self, sites, parts, self.boundary(node), ranges);
    }

    /// Joins a location, new and on the chain of the part that it belongs to, with the other part of a node. Where the
    /// node had a bridge, its other end can only have moved away from the location.
    fn join<S: Site>(&mut self, sites: &PresentSites<S>, node: usize, location: u32, is_left: bool) {
        let [p, q] = self.bridges[node];
        let had_bridge = p != VACANT && q != VACANT;
        self.bridges[node] = if is_left {
            let range = if had_bridge { q..=*EVERYWHERE.end() } else { EVERYWHERE };
            [location, touching(self, sites, location, Self::right(node), &range, false)]
        } else {
            let range = if had_bridge { *EVERYWHERE.start()..=p } else { EVERYWHERE };
            [touching(self, sites, location, Self::left(node), &range, true), location]
        };
    }
}

/// Whether a location replaces an end of a bridge when it joins the part on that side.
#[inline]
fn replaces_end<S: Site>(sites: &PresentSites<S>, [p, q]: [u32; 2], location: u32, is_left: bool) -> bool {
    match S::turn(sites.point(p), sites.point(q), sites.point(location)) {
        Turn::Straight => {
            if is_left {
                location < p
            } else {
                location > q
            }
        }
        turn => turn == sites.side.outward(),
    }
}

impl BridgeTree {
    /// The tree of the sites that are present.
    pub(super) fn build<S: Site>(sites: &PresentSites<S>) -> Self {
        let mut tree = Self::vacant(sites.sites.location_count());
        for location in sites.locations() {
            let mut node = tree.leaves + location as usize;
            while node > 1 {
                let end = node % 2;
                node /= 2;
                let was_vacant = tree.bridges[node] == [VACANT; 2];
                tree.bridges[node][end] = location;
                if !was_vacant {
                    break;
                }
            }
        }
        for node in (1..tree.leaves).rev() {
            if !tree.bridges[node].contains(&VACANT) {
                tree.renew(sites, node, [EVERYWHERE; 2]);
            }
        }
        tree
    }

    /// A location has its first site.
    pub(super) fn occupy<S: Site>(&mut self, sites: &PresentSites<S>, location: u32) {
        let mut node = self.leaves + location as usize;
        while node > 1 {
            let is_left = node.is_multiple_of(2);
            node /= 2;
            let [p, q] = self.bridges[node];
            let (own, other) = if is_left { (p, q) } else { (q, p) };
            if other == VACANT {
                if own != VACANT {
                    continue;
                }
                self.bridges[node] = if is_left { [location, VACANT] } else { [VACANT, location] };
            } else if own == VACANT || replaces_end(sites, [p, q], location, is_left) {
                self.join(sites, node, location, is_left);
            } else if is_left == (location > own) {
                // inside of the bridge, so no vertex of any larger part
                break;
            }
        }
    }

    /// A location has lost its last site.
    pub(super) fn vacate<S: Site>(&mut self, sites: &PresentSites<S>, location: u32) {
        let mut node = self.leaves + location as usize;
        let mut is_vacant = true;
        // the neighbours of the location on the chain of the part that was looked at last
        let mut neighbours = EVERYWHERE;
        while node > 1 {
            let is_left = node.is_multiple_of(2);
            node /= 2;
            let [p, q] = self.bridges[node];
            let (own, other) = if is_left { (p, q) } else { (q, p) };
            if is_vacant {
                self.bridges[node][usize::from(!is_left)] = VACANT;
                is_vacant = other == VACANT;
                if !is_vacant {
                    neighbours = if is_left { *EVERYWHERE.start()..=other } else { other..=*EVERYWHERE.end() };
                }
            } else if other == VACANT {
                continue;
            } else if own == location {
                let (first, last) = neighbours.into_inner();
                if is_left {
                    self.renew(sites, node, [first..=last, *EVERYWHERE.start()..=other]);
                    neighbours = first..=other;
                } else {
                    self.renew(sites, node, [other..=*EVERYWHERE.end(), first..=last]);
                    neighbours = other..=last;
                }
            } else if is_left == (location > own) {
                break;
            }
        }
    }

    /// [`HullChain::extreme`](super::HullChain::extreme) among locations.
    pub(super) fn extreme<S: Site>(&self, sites: &PresentSites<S>, direction: Direction) -> Option<u32> {
        let mut node = self.root(sites)?;
        loop {
            match self.descend(&mut node) {
                Node::Leaf(location) => return Some(location),
                Node::Bridge(ends) => {
                    let edge = ends.map(|end| sites.point(end));
                    node = match extreme_step(sites.side, edge, direction) {
                        Step::Right => Self::right(node),
                        _ => Self::left(node),
                    };
                }
            }
        }
    }

    /// [`HullChain::tangent`](super::HullChain::tangent) to locations.
    pub(super) fn tangent<S: Site>(&self, sites: &PresentSites<S>, from: &S, towards: Towards) -> LocationTangent {
        let Some(mut node) = self.root(sites) else { return LocationTangent::Unbounded };
        loop {
            match self.descend(&mut node) {
                Node::Leaf(location) => {
                    return tangent_to_site(sites.side, location, sites.point(location), from, towards);
                }
                Node::Bridge(ends) => {
                    let edge = ends.map(|end| sites.point(end));
                    node = match tangent_step(sites.side, edge, from, towards) {
                        Step::Left => Self::left(node),
                        Step::Right => Self::right(node),
                        Step::Hidden => return LocationTangent::Hidden,
                    };
                }
            }
        }
    }

    /// [`HullChain::vertices`](super::HullChain::vertices) among locations.
    pub(super) fn vertices<S: Site>(&self, sites: &PresentSites<S>) -> Vec<u32> {
        let mut found = Vec::new();
        let mut rest: Vec<(usize, [u32; 2])> = self.root(sites).map(|root| (root, [0, VACANT])).into_iter().collect();
        while let Some((mut node, [from, to])) = rest.pop() {
            match self.descend(&mut node) {
                Node::Leaf(location) => found.push(location),
                Node::Bridge([p, q]) => {
                    if q <= to {
                        rest.push((Self::right(node), [q.max(from), to]));
                    }
                    if p >= from {
                        rest.push((Self::left(node), [from, p.min(to)]));
                    }
                }
            }
        }
        found
    }

    /// The bytes that are held beside the sites.
    pub(super) fn bytes(&self) -> usize {
        self.bridges.capacity() * size_of::<[u32; 2]>()
    }
}
