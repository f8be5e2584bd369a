//! The methods for walks over facets by name.

use super::brute_force::BruteForceWalk;
use super::by_dynamic_hull::HullWalk;
use super::by_scan::ScanWalk;
use super::error::WalkError;
use super::interface::FacetWalk;
use crate::tables::methods;

methods! {
    /// A method that walks from facet to facet.
    pub enum Method;
    /// The cost of one step among n generators in general position.
    fn cost;

    /// [`by_dynamic_hull`](super::by_dynamic_hull), the paper's and the default.
    ByDynamicHull => "by_dynamic_hull", "Dynamic hulls of the dual lines", "O(log² n)";
    /// [`by_scan`](super::by_scan).
    ByScan => "by_scan", "A pass over the generators", "O(n)";
    /// [`brute_force`](super::brute_force).
    BruteForce => "brute_force", "The list of all facets", "O(1) after O(n³)";
}

impl Method {
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
