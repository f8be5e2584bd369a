//! One chain of a dynamic hull: the sites that are present, and a tree of bridges over their locations.

use std::sync::Arc;

use super::by_bridge_tree::BridgeTree;
use super::interface::{HullChain, Side, Tangent, Towards, UpdateError};
use super::present_sites::{LocationTangent, PresentSites};
use super::sites::{Direction, Site, SiteIndex, SortedSites};

/// One chain of the convex hull of the present sites.
#[derive(Debug, Clone)]
pub struct DynamicChain<S> {
    sites: PresentSites<S>,
    tree: BridgeTree,
}

impl<S: Site> DynamicChain<S> {
    /// The chain on one side of some of the sites. O(n) after the sites are sorted.
    ///
    /// # Errors
    /// [`UpdateError`] if an index of `present` is repeated or unknown.
    pub fn new(
        sites: Arc<SortedSites<S>>,
        side: Side,
        present: impl IntoIterator<Item = SiteIndex>,
    ) -> Result<Self, UpdateError> {
        let sites = PresentSites::new(sites, side, present)?;
        Ok(Self { tree: BridgeTree::build(&sites), sites })
    }
}

impl<S: Site> HullChain<S> for DynamicChain<S> {
    fn insert(&mut self, site: SiteIndex) -> Result<(), UpdateError> {
        if let Some(location) = self.sites.insert(site)? {
            self.tree.occupy(&self.sites, location);
        }
        Ok(())
    }

    fn delete(&mut self, site: SiteIndex) -> Result<(), UpdateError> {
        if let Some(location) = self.sites.delete(site)? {
            self.tree.vacate(&self.sites, location);
        }
        Ok(())
    }

    fn contains(&self, site: SiteIndex) -> bool {
        self.sites.contains(site)
    }

    fn len(&self) -> usize {
        self.sites.len()
    }

    fn extreme(&self, direction: Direction) -> Option<SiteIndex> {
        Some(self.sites.index(self.tree.extreme(&self.sites, direction)?))
    }

    fn tangent(&self, from: &S, towards: Towards) -> Tangent {
        match self.tree.tangent(&self.sites, from, towards) {
            LocationTangent::Touches(location) => Tangent::Touches(self.sites.index(location)),
            LocationTangent::Unbounded => Tangent::Unbounded,
            LocationTangent::Hidden => Tangent::Hidden,
        }
    }

    fn vertices(&self) -> Vec<SiteIndex> {
        self.tree.vertices(&self.sites).into_iter().map(|location| self.sites.index(location)).collect()
    }

    fn bytes(&self) -> usize {
        self.sites.bytes() + self.tree.bytes()
    }
}
