//! The distance of a point from a zonotope in pairs of doubles, where these tell the face on which the nearest point
//! lies.
//!
//! In a narrow cone around the direction from the nearest point nearly all generators have a fixed sign (the kernel's
//! sign pass). Let S be their sum and r = p − S. If at most two generators cross the cone, the nearest point of the
//! face that they span is the foot of r on their plane or line, and so is in the face if its coefficients are in (−1,
//! 1). Where the direction u from that foot to p is in the cone, all signs are those of u · g_i: no other point of the
//! body is nearer. Where more generators cross the cone, or the foot is not in the face, an active set among those that
//! cross it ([`active_set`]) leads to a narrower cone or to a wider one.
//!
//! One pass sums up S to twice the digits of a double, so that the distance is known beyond a double unless it is below
//! 2^-40 of the body; then the signs in that cone are summed up exactly. All that is asked of the numbers is certain
//! within their bounds; where it is not, there is no answer, and exact arithmetic finds one.

use std::cmp::Ordering;

use super::active_set::{self, Guess};
use super::direction_guess;
use super::fixed_signs::{fixed_coefficients, fixed_signs};
use super::rounded_vertices::RoundedVertices;
use crate::collision::proof::vectors::Vectors;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::difference;
use crate::numeric::linear::{cross, dot, euclidean_norm, max_norm};
use crate::numeric::tolerance::{KNOWN_SQUARE, SQUARABLE_SIZES};
use crate::tally::{Operation, Tally};

/// The least angle of the cone: rounding in doubles must leave no doubt that a direction is in it.
const LEAST_ANGLE: f64 = 1e-13;

/// The angle of the cone around a direction that may be the normal of a facet, rounded.
const FACET_ANGLE: f64 = 1e-11;

/// A vector known by pairs of doubles.
type PairVector = [BoundedDoubleDouble; 3];

/// The most generators that may cross a cone among which the nearest point is looked for.
const CROSSING_LIMIT: usize = 256;

/// The most cones that lead to each other.
const CONE_LIMIT: usize = 6;

/// As many generators as are likely to cross the first cone that is made wider.
const FIRST_CROSSING: f64 = 8.0;

/// By how much each later cone is wider than the one before.
const WIDENING: f64 = 8.0;

/// The distance, within two units in the last place; `start` is a direction in which the displacement is beyond the
/// body. `None` where pairs of doubles leave a doubt of it.
///
/// Near contact the direction that separates is mostly the normal of the facet on which the nearest point lies, or of
/// one beside it, so that its two generators are tried before any search.
pub(super) fn distance(query: &dyn KernelQuery, start: [f64; 3], tally: &mut dyn Tally) -> Option<f64> {
    let vectors = Vectors::of(query)?;
    let center = start.map(|c| c / max_norm(&start));
    let mut vertices = RoundedVertices::new(query);
    let first = vertices.extreme(&center, tally);
    if !vertices.is_far(&center, &first) {
        let around_start = DirectionCone { center, axes: None, ball: FACET_ANGLE * euclidean_norm(&center) };
        if let Some(distance) = in_cones(query, &vectors, around_start, 2, tally) {
            return Some(distance);
        }
    }
    let guess = direction_guess::approach(&mut vertices, center, first, tally)?;
    in_cones(query, &vectors, guess.at_least(LEAST_ANGLE), 0, tally)
}

/// The distance, if a cone or those that it leads to tell it; at least some generators are to cross the first one.
fn in_cones(
    query: &dyn KernelQuery,
    vectors: &Vectors<'_>,
    mut cone: DirectionCone,
    least_crossing: usize,
    tally: &mut dyn Tally,
) -> Option<f64> {
    let (mut least, mut widest) = (least_crossing, FIRST_CROSSING / query.len() as f64);
    let mut sum = Sum::InPairs;
    for _ in 0..CONE_LIMIT {
        let found = in_cone(query, vectors, &cone, least, sum, tally)?;
        least = 0;
        let Found::Guess(Guess { direction, doubt }) = found else {
            match (found, sum) {
                (Found::Distance(distance), _) => return Some(distance),
                (_, Sum::Exact) => return None,
                (_, Sum::InPairs) => sum = Sum::Exact,
            }
            continue;
        };
        let length = euclidean_norm(&cone.center);
        let off = [0, 1, 2].map(|k| direction[k] - cone.center[k] / length);
        let angle = euclidean_norm(&off);
        cone = if angle * length <= cone.ball {
            let narrow = DirectionCone { center: direction, axes: None, ball: doubt.max(LEAST_ANGLE) };
            // the same cone again would tell the same
            sum = if cone.ball <= 2.0 * narrow.ball * length { Sum::Exact } else { sum };
            narrow
        } else {
            let wider = DirectionCone { ball: (2.0 * angle + doubt).min(widest) * length, ..cone };
            widest *= WIDENING;
            wider
        };
    }
    None
}

/// The precision in which the generators are summed up whose sign is fixed in a cone.
#[derive(Debug, Clone, Copy)]
enum Sum {
    InPairs,
    Exact,
}

/// The outcome of a look at a cone of directions.
enum Found {
    Distance(f64),
    /// The cone holds the direction from the nearest point, but the distance is lost in the rounding of the sum.
    Unclear,
    /// The direction from the nearest point if no generator beside those that cross the cone changes its sign.
    Guess(Guess),
}

/// The distance, if the direction to the nearest point is in a cone that at most two generators cross; else the
/// direction that those which cross it lead to. Two passes.
fn in_cone(
    query: &dyn KernelQuery,
    vectors: &Vectors<'_>,
    cone: &DirectionCone,
    least_crossing: usize,
    sum: Sum,
    tally: &mut dyn Tally,
) -> Option<Found> {
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let (mut crossing, mut indices) = (Vec::new(), Places::new());
    query.split(cone, &mut crossing, &mut indices);
    if !(least_crossing..=CROSSING_LIMIT).contains(&indices.len()) {
        return None;
    }
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let rest = rest(query, cone, &indices, sum);
    let pair = |place: &u32| vectors.pairs(*place as usize);
    let face = match indices.as_slice() {
        [] => Some(Face::Vertex),
        [i] => Some(Face::Edge(pair(i))),
        [i, j] => Some(Face::Facet(pair(i), pair(j))),
        _ => None,
    };
    if let Some((direction, square)) = face.and_then(|face| face.foot(&rest)) {
        let is_optimal = cone.contains(&direction.map(|c| c.rounded()), &bounded::exact(cone.center));
        if is_optimal {
            return Some(root(square).map_or(Found::Unclear, Found::Distance));
        }
    }
    active_set::direction(&crossing, rest.map(|c| c.rounded().value), &cone.center).map(Found::Guess)
}

/// p less the generators whose sign is fixed in a cone.
fn rest(query: &dyn KernelQuery, cone: &DirectionCone, crossing: &[u32], sum: Sum) -> PairVector {
    match sum {
        Sum::InPairs => {
            let (sum, p) = (query.combined(&fixed_coefficients(query, cone, crossing)), query.displacement_pairs());
            [p[0] - sum[0], p[1] - sum[1], p[2] - sum[2]]
        }
        Sum::Exact => {
            let sum = query.signed_sum(&fixed_signs(query, cone, crossing));
            difference(&query.exact(), &sum).each_ref().map(BoundedDoubleDouble::of)
        }
    }
}

/// A face by the generators that span it.
enum Face {
    Vertex,
    Edge(PairVector),
    Facet(PairVector, PairVector),
}

impl Face {
    /// The direction to a point from its foot on the face, of any length, and the square of the distance; the centre of
    /// the face is the origin. `None` unless the foot is certainly within the face.
    fn foot(&self, r: &PairVector) -> Option<(PairVector, BoundedDoubleDouble)> {
        let is_less =
            |a: BoundedDoubleDouble, b: &BoundedDoubleDouble| a.abs().certain_order(b) == Some(Ordering::Less);
        match self {
            Self::Vertex => Some((*r, dot(r, r))),
            Self::Edge(v) => {
                let (along, square) = (dot(r, v), dot(v, v));
                let across = cross(r, v);
                let direction = [0, 1, 2].map(|k| r[k] * square - v[k] * along);
                is_less(along, &square).then(|| (direction, dot(&across, &across) / square))
            }
            Self::Facet(v, w) => {
                let normal = cross(v, w);
                let (along, square) = (dot(r, &normal), dot(&normal, &normal));
                let is_inside =
                    is_less(dot(&cross(r, w), &normal), &square) && is_less(dot(&cross(v, r), &normal), &square);
                let direction = if along.sign()? < 0 { normal.map(BoundedDoubleDouble::negated) } else { normal };
                is_inside.then(|| (direction, along * along / square))
            }
        }
    }
}

/// The root of a square that is known far beyond a double, rounded to the nearest double or the one beside it.
fn root(square: BoundedDoubleDouble) -> Option<f64> {
    let (pair, error) = square.parts();
    // false for NaN as well
    let is_known = SQUARABLE_SIZES.contains(&pair.high) && error <= KNOWN_SQUARE * pair.high;
    let first = pair.high.sqrt();
    let exact = BoundedDoubleDouble::exact(first);
    is_known.then(|| first + (square - exact * exact).high / (2.0 * first))
}
