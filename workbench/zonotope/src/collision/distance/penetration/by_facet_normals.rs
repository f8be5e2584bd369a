//! The penetration depth, by every facet normal in exact arithmetic.
//!
//! # Statement
//! Input: a displacement p and generators g_i of R^D, any D ≥ 1. Output: the distance of p from the boundary of Z = {
//! Σ δ_i g_i : |δ_i| ≤ 1 }, as a [`Penetration`] whose bounds differ by rounding alone; 0 unless p is inside, and so
//! for every p where Z is flat.
//!
//! # Source
//! Beyond the paper. Section 3 names the facets of a zonotope by sets of D − 1 generators.
//!
//! # Method
//! 1. Each D − 1 independent generators have one normal u, up to its sign; every facet normal is among these. All u
//!    with a positive length are outer normals of faces.
//! 2. The distance of p from the plane of that face is (Σ |u · g_i| − |u · p|) / |u|, for the nearer sign of u. If one
//!    of them is not positive, p is not inside. Otherwise the least one is the depth: the distance of a point of a
//!    convex body from its boundary is that from the nearest plane of a facet.
//!
//! # Complexity
//! n generators: O(n^D) exact operations.
//!
//! # Shapes
//! generators: n × D, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Exact but for the last step: the bounds are two units in the last place to both sides of a value that is within two
//! units of the depth.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), cubes by hand.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, distance::penetration::by_facet_normals};
//! // the point (1/2, 1/4) is 1/2 from the right side of the square [−1, 1]²
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let query = Query::new([0.0, 0.0], [0.5, 0.25], &square).unwrap();
//! let depth = by_facet_normals::penetration(&query);
//! assert!(depth.lower <= 0.5 && 0.5 <= depth.upper && depth.upper - depth.lower < 1e-15);
//! ```

use super::Penetration;
use super::nearest_plane::NearestPlane;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{hyperplane_normal, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use crate::zonotope::query::Query;

/// How deep the displacement of a query lies in the zonotope.
pub fn penetration<const D: usize>(query: &Query<'_, D>) -> Penetration<D> {
    let generators: Vec<[Dyadic; D]> = query.generators().map(|g| g.map(Dyadic::from_f64)).collect();
    let mut nearest = NearestPlane::of(query.exact());
    for_each_subset(generators.len(), D.saturating_sub(1), |subset| {
        let members: Vec<&[Dyadic; D]> = subset.iter().map(|&i| &generators[i]).collect();
        let normal = hyperplane_normal(&members);
        if nearest.is_inside() && normal.iter().any(|c| !c.is_zero()) {
            let reach = generators.iter().fold(Dyadic::zero(), |sum, g| sum + sum_of_products(&normal, g).abs());
            nearest.compare(normal, reach);
        }
    });
    nearest.depth()
}
