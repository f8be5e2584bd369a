//! The methods for walks over facets by name.

use super::brute_force::BruteForceWalk;
use super::by_dynamic_hull::HullWalk;
use super::by_scan::ScanWalk;
use super::error::WalkError;
use super::interface::FacetWalk;

/// A method that walks from facet to facet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_dynamic_hull`](super::by_dynamic_hull), the paper's and the default.
    #[default]
    ByDynamicHull,
    /// [`by_scan`](super::by_scan).
    ByScan,
    /// [`brute_force`](super::brute_force).
    BruteForce,
}

impl Method {
    /// Every method, better ones first.
    pub const ALL: [Self; 3] = [Self::ByDynamicHull, Self::ByScan, Self::BruteForce];

    /// The name of the method's file.
    pub fn id(self) -> &'static str {
        match self {
            Self::ByDynamicHull => "by_dynamic_hull",
            Self::ByScan => "by_scan",
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
            Self::ByDynamicHull => "Dynamic hulls of the dual lines",
            Self::ByScan => "A pass over the generators",
            Self::BruteForce => "The list of all facets",
        }
    }

    /// The cost of one step among n generators in general position.
    pub fn cost(self) -> &'static str {
        match self {
            Self::ByDynamicHull => "O(log² n)",
            Self::ByScan => "O(n)",
            Self::BruteForce => "O(1) after O(n³)",
        }
    }

    /// A walk over the facets of the zonotope of some generators, which starts at the facet of the first two that are
    /// not parallel.
    ///
    /// # Errors
    /// [`WalkError`] if a coordinate is not finite, the generators do not span space, or there are too many.
    pub fn walk(self, generators: &[[f64; 3]]) -> Result<Box<dyn FacetWalk>, WalkError> {
        Ok(match self {
            Self::ByDynamicHull => Box::new(HullWalk::new(generators)?),
            Self::ByScan => Box::new(ScanWalk::new(generators)?),
            Self::BruteForce => Box::new(BruteForceWalk::new(generators)?),
        })
    }
}
