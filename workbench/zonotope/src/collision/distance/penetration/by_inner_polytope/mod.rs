//! The penetration depth, by a polytope within the body that grows where its boundary is nearest to the point.
//!
//! # Statement
//! Input: a query in space, with a displacement p and the generators of a zonotope Z. Output: a [`Penetration`] whose
//! bounds hold the distance of p from the boundary of Z and differ by at most a hundredth of the upper one, for a p
//! inside of Z; 0 for all others, touching included, and so for every p where Z is flat.
//!
//! # Source
//! Beyond the paper, whose Lemma 5.1 makes one body of two. The expanding polytope of van den Bergen (2001) is the same
//! idea without bounds; here the nearest face bounds the depth from below for all directions at once.
//!
//! # Method
//! 1. The kernel decides whether p is inside: of a p outside it mostly knows that after a pass or two, where a polytope
//!    would have to grow up to the nearest face. Then 2 and 3 run in plain doubles with one margin for all rounding
//!    (`symmetric`), which mostly proves both bounds.
//! 2. The polytope begins as an octahedron of three extreme vertices of Z and their mirror images (`polytope`). Every
//!    point that it ever gets is a vertex of Z or the mirror image of one, so it stays within Z.
//! 3. The plane of the face that is nearest to p, or has p farthest behind it, has a normal u. The vertex of Z that is
//!    extreme along u joins the polytope with its mirror image. The value h(u) − u · p over |u| bounds the depth from
//!    above, as a translation of that length along u takes p out of Z; the least distance of a face bounds it from
//!    below, as the ball of that radius lies within the polytope.
//! 4. Else the search runs in doubles that carry bounds. Where their errors hide the last hundredth it is run again in
//!    pairs of doubles, and where these do not tell, either, in exact numbers (`precision`); of very few generators in
//!    these alone.
//!
//! # Complexity
//! n generators: O(n) for each new vertex, some ten to some hundred of them, the more the nearer Z is to a ball around
//! p; O(f) for the f faces of the polytope. In exact numbers each new vertex is a new one of finitely many.
//!
//! # Shapes
//! `query`: n × 3 generators in two runs, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Whether p is inside is exact. Bounds hold against all rounding: coordinates of the polytope, distances of its faces
//! and support values carry bounds of their errors. That the polytope may fail to be convex by such errors does not
//! matter to the bounds (`polytope`).
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on every family; [`by_facet_normals`](super::by_facet_normals).
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, distance::penetration::by_inner_polytope};
//! // two cubes [−1, 1]³ whose centres are (3/2, 1, 0) apart overlap by 1/2 along the first axis
//! let cubes = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
//! let query = Query::new([0.0; 3], [1.5, 1.0, 0.0], &cubes).unwrap();
//! let depth = by_inner_polytope::penetration(&query, &mut ());
//! assert!(depth.lower <= 0.5 && 0.5 <= depth.upper && depth.is_within(0.01));
//! ```

mod number;
mod polytope;
mod precision;
mod search_end;
mod symmetric;

use self::number::Number;
use self::polytope::Polytope;
use self::precision::{InDoubles, Listed, Precision};
pub use self::search_end::ACCURACY;
use self::search_end::{VERTEX_LIMIT, is_settled, is_too_short};
use super::Penetration;
use crate::collision::Location;
use crate::collision::by_lad::decide;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::linear::{Ring, cross, dot};
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::{Operation, Tally};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

/// The most generators of which the polytope grows in exact numbers at once: what doubles would spare is not felt, and
/// the bounds are as near as rounding leaves them.
const EXACT_COUNT: usize = 8;

/// The most vertices that the polytope gets in exact numbers; the bounds hold where it ends.
const EXACT_VERTEX_LIMIT: usize = 1 << 12;

/// The exponent by which units are smaller where the depth is below all products in them.
const UNIT_STEP: i64 = 800;

/// How deep the displacement of a query lies in the zonotope.
pub fn penetration<P: Standing>(query: &Query<'_, 3, P>, tally: &mut dyn Tally) -> Penetration<3> {
    match decide(query, tally) {
        Location::Inside(member) => {
            symmetric::depth(query, &member, tally).unwrap_or_else(|| of_inner_point(query, tally))
        }
        Location::Boundary(_) | Location::Outside(_) => Penetration::NONE,
    }
}

/// The depth of a displacement that is inside, by the first precision that tells it.
fn of_inner_point(query: &dyn KernelQuery, tally: &mut dyn Tally) -> Penetration<3> {
    if query.len() <= EXACT_COUNT {
        return in_exact_numbers(query, tally);
    }
    let (doubles, exponent) = InDoubles::new(query);
    let mut depth = grown(&doubles, VERTEX_LIMIT, tally);
    if !is_settled(&depth) {
        let (generators, end) = precision::exact_body(query, exponent);
        depth = grown(&Listed::in_pairs(&generators, &end), VERTEX_LIMIT, tally);
    }
    if is_settled(&depth) { outward(&depth, exponent) } else { in_exact_numbers(query, tally) }
}

/// The depth by a polytope in exact numbers.
///
/// The distances of its faces are doubles in units of the body's size. In these the depth of a very thin body is below
/// all doubles, so that it is found anew in smaller units.
fn in_exact_numbers(query: &dyn KernelQuery, tally: &mut dyn Tally) -> Penetration<3> {
    let mut in_units = |exponent: i64| {
        let (generators, end) = precision::exact_body(query, exponent);
        grown(&Listed::exactly(generators, end), EXACT_VERTEX_LIMIT, tally)
    };
    let exponents = (0..query.len()).flat_map(|index| query.exact_generator(index)).filter_map(|c| c.binary_exponent());
    let size = exponents.max().unwrap_or(0);
    let (mut exponent, mut depth) = (size, in_units(size));
    while is_too_short(&depth) && exponent >= size - UNIT_STEP {
        exponent -= UNIT_STEP;
        depth = in_units(exponent);
    }
    outward(&depth, exponent)
}

/// Bounds of a scaled body as bounds of the body: normal doubles but where the depth is nearly out of their range.
fn outward(depth: &Penetration<3>, exponent: i64) -> Penetration<3> {
    Penetration {
        lower: scale_by_power_of_two(depth.lower, exponent).next_down().max(0.0),
        upper: scale_by_power_of_two(depth.upper, exponent).next_up(),
        direction: depth.direction,
    }
}

/// The bounds that a growing polytope finds: within [`ACCURACY`], or as far as the precision goes.
fn grown<P: Precision>(body: &P, vertex_limit: usize, tally: &mut dyn Tally) -> Penetration<3> {
    let mut depth = Penetration { lower: 0.0, upper: f64::INFINITY, direction: [0.0; 3] };
    let Some(first) = first_vertices(body) else { return depth };
    let mut polytope = Polytope::octahedron(first, body.end());
    while polytope.vertex_count() < vertex_limit {
        let (normal, nearest) = polytope.nearest();
        depth.lower = nearest.max(0.0);
        if is_settled(&depth) {
            break;
        }
        let look = body.look(&normal);
        tally.add(Operation::SearchStep, 1);
        if look.distance < depth.upper {
            (depth.upper, depth.direction) = (look.distance, look.direction);
        }
        if is_settled(&depth) || is_too_short(&depth) || !polytope.add_with_mirror_image(look.vertex) {
            break;
        }
    }
    depth
}

/// Three extreme vertices that are independent but for rounding: the first along an axis, the others along directions
/// orthogonal to those before. `None` where nothing is known of them.
fn first_vertices<P: Precision>(body: &P) -> Option<[[P::Number; 3]; 3]> {
    let (one, zero) = (P::Number::ONE, P::Number::ZERO);
    let axes = [0, 1, 2].map(|k| std::array::from_fn(|i| if i == k { one.clone() } else { zero.clone() }));
    let farther = |a: &[P::Number; 3], b: &[P::Number; 3]| {
        let difference = dot(a, a).minus(&dot(b, b));
        difference.is_certainly_positive()
    };
    let first = axes.iter().map(|axis| body.look(axis).vertex).reduce(|a, b| if farther(&b, &a) { b } else { a })?;
    let sideways = axes.iter().map(|axis| cross(&first, axis)).reduce(|a, b| if farther(&b, &a) { b } else { a })?;
    let second = body.look(&sideways).vertex;
    let third = body.look(&cross(&first, &second)).vertex;
    let volume = dot(&cross(&first, &second), &third);
    volume.is_certainly_positive().then_some([first, second, third])
}
