//! The methods for planar hulls by name.

use super::{ConvexHull, HullError, brute_force, by_discarding, by_monotone_chain};
use crate::tables::methods;
use crate::tally::Tally;

methods! {
    /// A method that finds the convex hull of points of the plane.
    pub enum Method;
    /// The cost for n points, m of them left after the first pass and h on the hull.
    fn cost;

    /// [`by_discarding`], the default.
    ByDiscarding => "by_discarding", "Discarding inner points first", "O(n + m log m)";
    /// [`by_monotone_chain`].
    ByMonotoneChain => "by_monotone_chain", "Monotone chains", "O(n log n)";
    /// [`brute_force`].
    BruteForce => "brute_force", "Gift wrapping", "O(n h)";
}

impl Method {
    /// The convex hull of some points.
    ///
    /// # Errors
    /// [`HullError`] if there are no points, too many, or a coordinate that is not finite.
    pub fn convex_hull(self, points: &[[f64; 2]], tally: &mut impl Tally) -> Result<ConvexHull, HullError> {
        match self {
            Self::ByDiscarding => by_discarding::convex_hull(points, tally),
            Self::ByMonotoneChain => by_monotone_chain::convex_hull(points, tally),
            Self::BruteForce => brute_force::convex_hull(points, tally),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_agree() {
        let points = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [4.0, 3.0], [2.0, 0.0]];
        for method in Method::ALL {
            let hull = method.convex_hull(&points, &mut ()).expect("finite points");
            assert_eq!(hull.vertices(), [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [1.0, 1.0]], "{method:?}");
            assert!(method.convex_hull(&[], &mut ()).is_err());
            assert_eq!(Method::from_id(method.id()), Some(method));
        }
    }
}
