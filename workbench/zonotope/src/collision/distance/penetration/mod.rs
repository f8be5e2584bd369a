//! Problem: how deep two bodies overlap, that is by how much one must be moved at least so that they only touch.
//!
//! Let the displacement p of the centres lie inside the zonotope Z of the generators of both bodies. Moving the second
//! body by t takes p to p + t, so the least translation is the distance of p from the boundary of Z. That is the least
//! h(u) − u · p over unit vectors u, h the support function of Z, and is attained at the outer normal of a facet. The
//! function is not convex over the sphere: only a search that looks at all directions proves the least value.
//!
//! | method | dimensions | cost for n generators | what it is |
//! |---|---|---|---|
//! | [`by_inner_polytope`] (default in space) | 3 | O(n) for each of some ten to some hundred vertices | a polytope that grows within the body |
//! | [`by_sides`] (default in the plane) | 2 | O(n log n), exact | a walk along the sides of the zonogon |
//! | [`by_facet_normals`] (default elsewhere) | any D | O(n^D), exact | every facet normal in exact arithmetic |
//! | [`brute_force`] | any D | O(n^D), exact rationals | the truth: every normal of D − 1 generators |

mod answer;
pub mod brute_force;
pub mod by_facet_normals;
pub mod by_inner_polytope;
pub mod by_sides;
mod nearest_plane;
#[cfg(test)]
mod tests;

pub use answer::Penetration;

use crate::zonotope::query::Query;

/// How deep the displacement of a query lies in the zonotope, by the default method of the dimension.
#[inline(never)]
pub fn of_query<const D: usize>(query: &Query<'_, D>) -> Penetration<D> {
    if let Some(query) = query.in_dimension::<3>() {
        return by_inner_polytope::penetration(&query, &mut ()).in_dimension();
    }
    if let Some(query) = query.in_dimension::<2>() {
        return by_sides::penetration(&query).in_dimension();
    }
    by_facet_normals::penetration(query)
}
