//! Distance of bodies and depth of their overlap, as methods of the bodies.

use crate::collision::distance::penetration::{self, Penetration};
use crate::collision::distance::{Proximity, by_support_simplex};
use crate::zonotope::Zonotope;
use crate::zonotope::query::Query;

impl<const D: usize> Zonotope<D> {
    /// The Euclidean distance of two closed bodies, 0 where they meet; within two units in the last place. Expected
    /// O(n), in space mostly in doubles and pairs of them. Points, faces and coefficients that prove it are those of
    /// [`proximity`](Self::proximity), whose cost is several times that.
    pub fn distance(&self, other: &Self) -> f64 {
        by_support_simplex::distance(&Query::between(self, other), &mut ())
    }

    /// Proximity of two closed bodies: their distance with the points, faces and coefficients that prove it, or how
    /// they meet. In one to three dimensions; more do not compile. Expected O(n) for each of a few steps.
    pub fn proximity(&self, other: &Self) -> Proximity<D> {
        let query = Query::between(self, other);
        by_support_simplex::proximity(&query, &mut ()).with_nearest_basis(&query)
    }

    /// Depth to which two bodies overlap: the length of the shortest translation after which they only touch, within a
    /// hundredth, and its direction; 0 for bodies without a common inner point. In space O(n) for each of some ten to
    /// some hundred vertices, in the plane O(n log n), elsewhere O(n^D) exact operations.
    pub fn penetration(&self, other: &Self) -> Penetration<D> {
        penetration::of_query(&Query::between(self, other))
    }
}
