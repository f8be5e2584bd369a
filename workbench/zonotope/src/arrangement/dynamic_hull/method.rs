//! The methods for one chain of a dynamic hull by name.

use std::sync::Arc;

use super::brute_force::BruteForce;
use super::by_bridge_tree::BridgeTree;
use super::by_logarithmic_method::Logarithmic;
use super::by_rebuilding::Rebuilding;
use super::chain::Chain;
use super::interface::{HullChain, Side, UpdateError};
use super::sites::{Site, SiteIndex, SortedSites};

/// A method that keeps one chain of the hull of the present sites.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_bridge_tree`](super::by_bridge_tree), the paper's and the default.
    #[default]
    ByBridgeTree,
    /// [`by_rebuilding`](super::by_rebuilding).
    ByRebuilding,
    /// [`by_logarithmic_method`](super::by_logarithmic_method).
    ByLogarithmicMethod,
    /// [`brute_force`](super::brute_force).
    BruteForce,
}

impl Method {
    /// Every method, better ones first.
    pub const ALL: [Self; 4] = [Self::ByBridgeTree, Self::ByRebuilding, Self::ByLogarithmicMethod, Self::BruteForce];

    /// The name of the method's file.
    pub fn id(self) -> &'static str {
        match self {
            Self::ByBridgeTree => "by_bridge_tree",
            Self::ByRebuilding => "by_rebuilding",
            Self::ByLogarithmicMethod => "by_logarithmic_method",
            Self::BruteForce => "brute_force",
        }
    }

    /// The method with a name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The name for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::ByBridgeTree => "A tree of bridges",
            Self::ByRebuilding => "Rebuilding when the chain is hit",
            Self::ByLogarithmicMethod => "The logarithmic method",
            Self::BruteForce => "All sites in rationals",
        }
    }

    /// The cost of one update among n sites, h of them vertices.
    pub fn cost(self) -> &'static str {
        match self {
            Self::ByBridgeTree => "O(log² n)",
            Self::ByRebuilding => "O(log h) off the chain, O(n) on it",
            Self::ByLogarithmicMethod => "insertion O(log n) amortised, deletion O(n) at worst",
            Self::BruteForce => "O(1); a query O(n) in rationals",
        }
    }

    /// The chain on one side of some of the sites.
    ///
    /// # Errors
    /// [`UpdateError`] if an index of `present` is repeated or unknown.
    pub fn chain<S: Site + 'static>(
        self,
        sites: Arc<SortedSites<S>>,
        side: Side,
        present: impl IntoIterator<Item = SiteIndex>,
    ) -> Result<Box<dyn HullChain<S>>, UpdateError> {
        Ok(match self {
            Self::ByBridgeTree => Box::new(Chain::<S, BridgeTree>::new(sites, side, present)?),
            Self::ByRebuilding => Box::new(Chain::<S, Rebuilding>::new(sites, side, present)?),
            Self::ByLogarithmicMethod => Box::new(Chain::<S, Logarithmic>::new(sites, side, present)?),
            Self::BruteForce => Box::new(BruteForce::new(sites, side, present)?),
        })
    }
}
