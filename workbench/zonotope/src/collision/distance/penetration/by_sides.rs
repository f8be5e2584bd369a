//! The penetration depth in the plane, by a walk along the sides of the zonogon.
//!
//! # Statement
//! Input: a query in the plane, with a displacement p and the generators of a zonogon Z. Output: the distance of p
//! from the boundary of Z, as a [`Penetration`] whose bounds differ by rounding alone; 0 unless p is inside, and so for
//! every p where Z is flat.
//!
//! # Source
//! Beyond the paper. Section 4.1 has the zonogon as a polygon.
//!
//! # Method
//! 1. The generators, turned to the right and sorted by angle with parallel ones added up, are half the sides of the
//!    zonogon, in order.
//! 2. Along the normal u of generator t, turned to the left of it, those after t count with a plus sign and those
//!    before it with a minus sign. So the sum with these signs, which changes by one generator from side to side, gives
//!    h(u).
//! 3. The distance of p from the nearer of the lines of the side and of the opposite one is (h(u) − |u · p|) / |u|. The
//!    least one is the depth.
//!
//! # Complexity
//! n generators: O(n log n) exact comparisons and O(n) exact operations, where trying all generators for each side
//! takes O(n²).
//!
//! # Shapes
//! generators: n × 2, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Exact but for the last step: the bounds are two units in the last place to both sides of a value that is within two
//! units of the depth.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), [`by_facet_normals`](super::by_facet_normals).
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, distance::penetration::by_sides};
//! // the point (1/2, 1/4) is 1/2 from the right side of the square [−1, 1]²
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let query = Query::new([0.0, 0.0], [0.5, 0.25], &square).unwrap();
//! let depth = by_sides::penetration(&query);
//! assert!(depth.lower <= 0.5 && 0.5 <= depth.upper && depth.upper - depth.lower < 1e-15);
//! ```

use super::Penetration;
use super::nearest_plane::NearestPlane;
use crate::numeric::dyadic::Dyadic;
use crate::zonotope::Zonotope;
use crate::zonotope::query::Query;

/// How deep the displacement of a query lies in the zonogon.
pub fn penetration(query: &Query<'_, 2>) -> Penetration<2> {
    let generators = query.generators().copied().collect();
    let sides = Zonotope::new([0.0; 2], generators).expect("the generators of a query are finite").sorted_generators();
    let mut nearest = NearestPlane::of(query.exact());
    let mut sum = sides.iter().fold([Dyadic::zero(), Dyadic::zero()], |[x, y], g| [x + g[0].clone(), y + g[1].clone()]);
    for [x, y] in &sides {
        // the side's own generator is orthogonal to u, and counts with a minus sign from the next side on
        let reach = x * &sum[1] - y * &sum[0];
        nearest.compare(vec![-y.clone(), x.clone()], reach);
        sum = [&sum[0] - &x.clone().scaled(1), &sum[1] - &y.clone().scaled(1)];
    }
    nearest.depth()
}
