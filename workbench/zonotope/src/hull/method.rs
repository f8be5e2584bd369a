//! The methods for planar hulls by name.

use super::{ConvexHull, HullError, brute_force, by_discarding, by_monotone_chain};
use crate::tally::Tally;

/// A method that finds the convex hull of points of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_discarding`], the default.
    #[default]
    ByDiscarding,
    /// [`by_monotone_chain`].
    ByMonotoneChain,
    /// [`brute_force`].
    BruteForce,
}

impl Method {
    /// Every method, better ones first.
    pub const ALL: [Self; 3] = [Self::ByDiscarding, Self::ByMonotoneChain, Self::BruteForce];

    /// The name of the method's file.
    pub fn id(self) -> &'static str {
        match self {
            Self::ByDiscarding => "by_discarding",
            Self::ByMonotoneChain => "by_monotone_chain",
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
            Self::ByDiscarding => "Discarding inner points first",
            Self::ByMonotoneChain => "Monotone chains",
            Self::BruteForce => "Gift wrapping",
        }
    }

    /// The cost for n points, m of them left after the first pass and h on the hull.
    pub fn cost(self) -> &'static str {
        match self {
            Self::ByDiscarding => "O(n + m log m)",
            Self::ByMonotoneChain => "O(n log n)",
            Self::BruteForce => "O(n h)",
        }
    }

    /// The convex hull of some points.
    ///
    /// # Errors
    /// [`HullError`] if there are no points, too many, or a coordinate that is not finite.
    pub fn convex_hull(self, points: &[[f64; 2]], tally: &mut impl Tally) -> Result<ConvexHull, HullError> {
        match self {
            Self::ByDiscarding => by_discarding::convex_hull_counted(points, tally),
            Self::ByMonotoneChain => by_monotone_chain::convex_hull_counted(points, tally),
            Self::BruteForce => brute_force::convex_hull_counted(points, tally),
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
