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
//! # Errors
//! None: a [`Query`] is valid.
//!
//! # Panics
//! Never.
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
use crate::collision::distance::answer::rounded_length;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{hyperplane_normal, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use crate::zonotope::query::Query;

/// The plane of a facet, as far as it has been found to be the nearest.
struct Nearest {
    normal: Vec<Dyadic>,
    /// The distance of the plane times the length of the normal.
    along: Dyadic,
    /// The square of the length of the normal.
    square: Dyadic,
}

/// How deep the displacement of a query lies in the zonotope.
pub fn penetration<const D: usize>(query: &Query<'_, D>) -> Penetration<D> {
    let generators: Vec<[Dyadic; D]> = query.generators().map(|g| g.map(Dyadic::from_f64)).collect();
    of_exact(&query.exact(), &generators)
}

/// The same for exact vectors.
pub(super) fn of_exact<const D: usize>(p: &[Dyadic; D], generators: &[[Dyadic; D]]) -> Penetration<D> {
    let mut best: Option<Nearest> = None;
    let mut is_inside = true;
    for_each_subset(generators.len(), D.saturating_sub(1), |subset| {
        let members: Vec<&[Dyadic; D]> = subset.iter().map(|&i| &generators[i]).collect();
        let normal = hyperplane_normal(&members);
        if !is_inside || D == 0 || normal.iter().all(Dyadic::is_zero) {
            return;
        }
        let reach = generators.iter().fold(Dyadic::zero(), |sum, g| sum + sum_of_products(&normal, g).abs());
        let level = sum_of_products(&normal, p);
        let is_opposite = level.sign().is_lt();
        let along = reach - level.abs();
        is_inside &= along.sign().is_gt();
        let square = sum_of_products(&normal, &normal);
        let is_nearer = |best: &Nearest| &(&along * &along) * &best.square < &(&best.along * &best.along) * &square;
        if best.as_ref().is_none_or(is_nearer) {
            let normal = if is_opposite { normal.into_iter().map(|c| -c).collect() } else { normal };
            best = Some(Nearest { normal, along, square });
        }
    });
    let Some(Nearest { normal, along, square }) = best.filter(|_| is_inside) else { return Penetration::NONE };
    let depth = rounded_length(&along, &square);
    let exponent = normal.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    Penetration {
        lower: depth.next_down().next_down().max(0.0),
        upper: depth.next_up().next_up(),
        direction: std::array::from_fn(|k| normal[k].clone().scaled(-exponent).to_f64()),
    }
}
