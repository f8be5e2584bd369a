//! The distance of two bodies, by simplices of extreme vertices: in doubles until the face is known, then exactly.
//!
//! # Statement
//! Input: a query in one to three dimensions, that is a displacement p and the generators of a zonotope Z. Output: a
//! [`Proximity`]. If p is outside of Z, the point x of Z that is nearest to p: its coefficients, the direction of
//! p − x, the faces that it lies on, and a point of each body. x is unique, its coefficients need not be; where
//! generators of both bodies are orthogonal to the direction, one of many pairs of nearest points is found. Touching
//! is an outcome of its own, and every contact of bodies whose sum is flat is touching. An empty body is a point.
//!
//! # Source
//! Lemma 5.1: the distance of two bodies is that of the displacement of their centres from the zonotope of the
//! generators of both. The paper decides whether it is 0; distances are beyond it.
//!
//! # Method
//! 1. The kernel ([`by_lad`](crate::collision::by_lad)) decides whether p is in Z, exactly. If not, it finds a
//!    direction in which p is beyond Z.
//! 2. From there, simplices of extreme vertices come nearer and nearer to p in doubles, and tell how far the direction
//!    of p − x may be from the one that is known (`direction_guess`). Near contact, where the rounding of sums hides
//!    that direction, the vertices are summed up exactly.
//! 3. In the cone of these directions nearly all generators have a fixed sign. They are summed up, exactly (the
//!    kernel's sign pass). What is left is the same problem for the few generators that cross the cone.
//! 4. That problem is solved exactly: mostly at most two generators are left, and the point is in the interior of
//!    their face; else again by simplices of extreme vertices (`exact_descent`, `exact_simplex`).
//! 5. If the direction u that is found is in the cone, all signs are those of u · g_i, so x is extreme in Z in the
//!    direction u and no other point of Z is nearer. Otherwise the cone is made wider, and 3 to 5 are repeated. A cone
//!    with the origin inside is crossed by all generators, so that ends.
//! 6. The generators orthogonal to u span the face of x; `face_point` finds their coefficients.
//!
//! Of the distance alone, pairs of doubles take the place of exact numbers in 3 to 5 where they leave no doubt
//! (`in_pairs`).
//!
//! # Complexity
//! n generators: expected O(n) for the kernel, and O(n) for each of some ten steps until the cone is narrow; then few
//! generators are left, unless many are orthogonal to u. Each of m such generators takes part in exact operations, a
//! few for each exact step. At worst all n, and as many steps as there are simplices; so it is with generators shorter
//! than 2^-450 or longer than 2^500, whose signs the passes in doubles do not tell. Space O(n).
//!
//! # Shapes
//! `query`: n × D generators in two runs, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! All decisions are exact: the status, the signs, the face. The distance is exact as a ratio, and rounded to within
//! two units in the last place. Coefficients of the basis are rounded to nearest, points of bodies to within a unit in
//! the last place.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on every family, the degenerate ones included; the optimality of each answer in
//! rationals.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, distance::by_support_simplex};
//! // the square [−1, 1]² and the point (4, 5): the corner (1, 1) is nearest
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let query = Query::new([0.0, 0.0], [4.0, 5.0], &square).unwrap();
//! let gap = by_support_simplex::proximity(&query, &mut ());
//! assert_eq!((gap.distance(), gap.gap().unwrap().points[0]), (5.0, [1.0, 1.0]));
//! ```

mod active_set;
mod direction_guess;
mod exact_descent;
mod exact_simplex;
mod face_point;
mod fixed_signs;
mod in_pairs;
mod nearest_point;
mod report;
mod rounded_vertices;
#[cfg(test)]
mod tests;

use super::Proximity;
use crate::collision::by_lad::{decide, locate};
use crate::collision::{Location, Separation};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::exact_linear::ExactVector;
use crate::tally::Tally;
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Standing;
use crate::zonotope::query::{Query, padded};

/// The proximity of the bodies of a query where they stand: how far apart they are, or how they meet.
pub fn proximity<const D: usize, P: Standing>(query: &Query<'_, D, P>, tally: &mut dyn Tally) -> Proximity<D> {
    const { assert!(D <= 3, "distances are known in up to three dimensions") }
    match locate(query, tally) {
        Location::Inside(witness) => Proximity::Overlapping(witness),
        Location::Boundary(witness) => Proximity::Touching(witness),
        Location::Outside(separation) => {
            let start = padded(&direction(&separation));
            let gap = match query.in_dimension::<3>() {
                Some(query) => in_space(&query, &query.ends(), start, tally),
                None => {
                    // bodies of the plane and the line are flat bodies of space
                    let [first, second] = query.parts().each_ref().map(|body| {
                        let generators = body.generators().iter().map(padded).collect();
                        Zonotope::new(padded(&body.center()), generators).expect("a query is finite")
                    });
                    let query = Query::between(&first, &second);
                    in_space(&query, &query.ends(), start, tally)
                }
            };
            Proximity::Disjoint(Box::new(report::lowered(gap)))
        }
    }
}

/// The distance of the bodies of a query where they stand, 0 where they meet; within two units in the last place.
///
/// It is that of [`proximity`], or the double beside it: pairs of doubles know it where they know the face of the
/// nearest point, and nothing but the distance is made.
pub fn distance<const D: usize, P: Standing>(query: &Query<'_, D, P>, tally: &mut dyn Tally) -> f64 {
    if let Some(query) = query.in_dimension::<3>() {
        let Location::Outside(separation) = decide(&query, tally) else { return 0.0 };
        let start = direction(&separation);
        return in_pairs::distance(&query, start, tally)
            .unwrap_or_else(|| in_space(&query, &query.ends(), start, tally).distance());
    }
    proximity(query, tally).distance()
}

#[inline(never)]
fn in_space(query: &dyn KernelQuery, ends: &[ExactVector; 2], start: [f64; 3], tally: &mut dyn Tally) -> super::Gap<3> {
    let nearest = nearest_point::find(query, start, tally);
    report::gap(query, ends, nearest)
}

/// A separating direction in doubles, at least nearly.
fn direction<const D: usize>(separation: &Separation<D>) -> [f64; D] {
    match separation {
        Separation::Rounded(direction) => *direction,
        Separation::Exact(direction) => direction.each_ref().map(|c| c.to_f64().value()),
    }
}
