//! The facet through which a ray left the sum of both bodies, for the next displacement while the bodies only
//! translate: whether that is inside, by some products of vectors.
//!
//! Let g be the sum of all generators off the facet with their signs, a and b the two generators of the facet and u =
//! ± a × b its normal, u · p > 0. Then λ p = g + δ_a a + δ_b b with λ = g · u / p · u, and the coefficients δ_a and δ_b
//! are ± g · (b × p) and ± g · (p × a) over p · u. For any p for which both are in [−1, 1], λ p is a point of the body,
//! whether or not the ray leaves there; where λ > 1 as well, p is inside. So a displacement that moves along the facet
//! is told in O(1), however near to the facet it is.

use crate::collision::proof::balance::triple::Triple;
use crate::lad::of_generators::optimum::Optimum;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::linear::dot;

/// The quantities of a proof that the ray leaves through a facet.
#[derive(Debug, Clone, Copy)]
pub(super) struct ExitFacet {
    /// a and b.
    vectors: [BoundedVector; 2],
    /// u, which is ± a × b.
    normal: BoundedVector,
    /// g.
    sum: BoundedVector,
    /// g · u.
    reach: Bounded,
}

impl ExitFacet {
    /// The facet of an optimum, if doubles prove that it is one.
    pub(super) fn of(optimum: &Optimum) -> Option<Self> {
        let Optimum::Rounded(decided) = optimum else { return None };
        let optimum = &decided.optimum;
        let vectors = optimum.bounded_vectors();
        let facet = Self { vectors, normal: optimum.direction, sum: optimum.sum, reach: optimum.reach };
        optimum.is_vertex().then_some(facet)
    }

    /// Whether a displacement is certainly inside, by this facet.
    pub(super) fn holds_inside(&self, p: &BoundedVector) -> bool {
        let along = dot(&self.normal, p);
        let [a, b] = &self.vectors;
        let [first, second, _] = Triple::new(&[*a, *b, *p]).coefficients(&self.sum);
        along.is_positive() && (self.reach - along).is_positive() && first.is_some() && second.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Query;
    use crate::lad::of_generators::goal::Goal;
    use crate::lad::of_generators::solve;
    use crate::numeric::bounded::exact;

    #[test]
    fn the_top_of_a_cube_tells_of_what_is_below_it() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let query = Query::new([0.0; 3], [0.1, 0.2, 0.9], &cube).expect("finite");
        let facet = ExitFacet::of(&solve(&query, Goal::Location, &mut ())).expect("the ray leaves through the top");
        let holds = |p: [f64; 3]| facet.holds_inside(&exact(p));
        assert!(holds([0.9, -0.9, 1.0 - 1e-12]) && holds([0.0, 0.0, 1e-3]));
        // on the top and above it; a ray that leaves through a side, along one, and down
        for p in [[0.5, 0.5, 1.0], [0.0, 0.0, 1.1], [0.8, 0.0, 0.7], [0.7, 0.0, 0.7], [0.0, 0.0, -0.5], [0.0; 3]] {
            assert!(!holds(p), "{p:?}");
        }
    }
}
