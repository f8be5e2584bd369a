//! A cone of directions that probably holds the direction from the nearest point, in doubles: nothing but speed depends
//! on it.
//!
//! It is the search of [`by_gjk`](crate::collision::by_gjk), which goes on until the nearest point is known: let y be
//! the point of a simplex nearest to the displacement, seen from the displacement, and w the extreme vertex in the
//! direction −y. The nearest point of the body is no farther from y than √(y · y − y · w), which bounds the angle
//! between the directions to both.
//!
//! Near contact the vector between the bodies is lost in the rounding of long sums. There the vertices are summed up
//! exactly and rounded as seen from the displacement, where those that count are short.

use super::vertices::{ExactVertices, RoundedVertices, Vertices};
use crate::collision::by_gjk::nearest::Simplex;
use crate::lad::of_generators::cells::direction_cone::DirectionCone;
use crate::lad::of_generators::generators::KernelQuery;
use crate::numeric::exact_linear::{ExactVector, exact, rounded_direction};
use crate::numeric::linear::{dot, euclidean_norm};
use crate::numeric::tolerance::{CONTACT_ANGLE, SEPARATING_DIRECTION_DOUBT};
use crate::tally::{Operation, Tally};

/// The most extreme vertices that are looked at.
const STEPS: u32 = 128;

/// A cone around the direction to the displacement `p` of a query from the nearest point, as far as doubles know it;
/// `start` is a direction in which the displacement is beyond the body, and the best that is known in contact.
pub(super) fn cone(query: &dyn KernelQuery, p: &ExactVector, start: [f64; 3], tally: &mut dyn Tally) -> DirectionCone {
    approach(&mut RoundedVertices::new(query), start, tally)
        .or_else(|| approach(&mut ExactVertices::new(query, p), start, tally))
        .unwrap_or(DirectionCone { center: start, axes: None, ball: SEPARATING_DIRECTION_DOUBT })
}

/// The cone that simplices of extreme vertices lead to; `None` if rounding hides the direction.
fn approach(vertices: &mut impl Vertices, start: [f64; 3], tally: &mut dyn Tally) -> Option<DirectionCone> {
    let mut simplex = Simplex::<3>::new();
    let mut direction = start;
    let mut last: Option<([f64; 3], f64)> = None;
    let mut known: Option<DirectionCone> = None;
    for _ in 0..STEPS {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, vertices.read_count() as u64);
        let (vertex, rounding) = vertices.extreme(&direction);
        if let Some((nearest, square)) = last {
            let length = square.sqrt();
            // not known for NaN as well
            let is_contact = rounding.is_nan() || rounding >= CONTACT_ANGLE * length;
            if is_contact {
                return None;
            }
            let excess = square - dot(&nearest, &vertex);
            // where no vertex is farther but for rounding, the point is off by rounding alone
            let off = if excess <= rounding * length { 0.0 } else { excess.sqrt() };
            if off < length {
                let center = rounded_direction(&exact(nearest.map(|c| -c)));
                let cone =
                    DirectionCone { center, axes: None, ball: (off + rounding) / length * euclidean_norm(&center) };
                known = Some(cone);
                vertices.narrow(&cone);
            }
            if off == 0.0 {
                return known;
            }
        }
        let Some(nearest) = simplex.add(vertex) else { return known };
        let square = dot(&nearest, &nearest);
        let is_nearer = last.is_none_or(|(_, last)| square < last);
        if simplex.is_full() || !is_nearer || !square.is_normal() {
            return known;
        }
        direction = nearest.map(|c| -c);
        last = Some((nearest, square));
    }
    known
}
