//! How far an enclosing body reaches beyond the body that was reduced.

use super::answer::{Containment, Reduced};
use super::hausdorff::{Distance, Limit, excess_with_limit};
use super::share_distance::ShareDistance;
use crate::zonotope::Zonotope;

impl<const D: usize> Reduced<D> {
    /// The Hausdorff distance from the body that was reduced, as [`hausdorff::excess`](super::hausdorff::excess) has it
    /// for a width, and not above what the shares prove.
    #[inline(never)]
    pub fn distance(&self, reduced: &Zonotope<D>, width: f64) -> Distance<D> {
        self.distance_by(reduced, width, Limit::ANSWER)
    }

    /// The same with a limit of its own on the work.
    pub(super) fn distance_by(&self, reduced: &Zonotope<D>, width: f64, limit: Limit) -> Distance<D> {
        let distance = excess_with_limit(&self.body, reduced, width, limit);
        match &self.proof {
            Containment::Shares(shares) => distance.at_most(ShareDistance::new(shares, reduced, &self.body).bound()),
            Containment::FacetNormals => distance,
        }
    }
}
