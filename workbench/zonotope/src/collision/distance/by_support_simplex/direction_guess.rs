//! A cone of directions that probably holds the direction from the nearest point, in doubles: nothing but speed depends
//! on it.
//!
//! It is the search of Gilbert, Johnson and Keerthi, which goes on until the nearest point is known: let y be the point
//! of a simplex nearest to the displacement, seen from the displacement, and w the extreme vertex in the direction −y.
//! The nearest point of the body is no farther from y than √(y · y − y · w), which bounds the angle between the
//! directions to both.
//!
//! Near contact the vector between the bodies is lost in the rounding of long sums, and simplices of near vertices and
//! far ones are flat to rounding. There the vertices are summed up exactly and the simplices are exact
//! (`exact_simplex`); the directions in which extreme vertices are looked for are rounded all the same.

use super::exact_simplex::ExactSimplex;
use super::fixed_signs::fixed_signs;
use super::rounded_vertices::{Extreme, RoundedVertices};
use crate::collision::distance::nearest_simplex::NearestSimplex;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::exact_linear::{ExactVector, difference, negated, rounded_direction};
use crate::numeric::linear::{dot, euclidean_norm, max_norm};
use crate::numeric::scaling::{PowerOfTwo, binary_exponent};
use crate::numeric::tolerance::{CONTACT_ANGLE, EXACT_DIRECTION_ROUNDING, SEPARATING_DIRECTION_DOUBT};
use crate::tally::{Operation, Tally};

/// The most extreme vertices that are looked at.
const STEPS: u32 = 128;

/// So many generators that cross a cone are solved for exactly as quickly as another vertex is found.
const CROSSING_COUNT: f64 = 4.0;

/// As many generators as may cross the cone of a search in doubles that ended early.
const WIDEST_CROSSING_COUNT: f64 = 64.0;

/// A cone around the direction to the displacement `p` of a query from the nearest point, as far as doubles know it;
/// `start` is a direction in which the displacement is beyond the body.
pub(super) fn cone(query: &dyn KernelQuery, p: &ExactVector, start: [f64; 3], tally: &mut dyn Tally) -> DirectionCone {
    let mut vertices = RoundedVertices::new(query);
    let first = vertices.extreme(&start, tally);
    approach(&mut vertices, start, first, tally).unwrap_or_else(|| approach_exactly(query, p, start, tally))
}

/// The cone that exact simplices of extreme vertices lead to, from a separating direction: until the generators that
/// cross it are probably few.
fn approach_exactly(query: &dyn KernelQuery, p: &ExactVector, start: [f64; 3], tally: &mut dyn Tally) -> DirectionCone {
    let mut simplex: Option<ExactSimplex> = None;
    let mut cone = DirectionCone { center: start, axes: None, ball: SEPARATING_DIRECTION_DOUBT };
    for _ in 0..STEPS {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let vertex = difference(&query.signed_sum(&fixed_signs(query, &cone, &[])), p);
        match &mut simplex {
            None => simplex = Some(ExactSimplex::of(vertex)),
            Some(simplex) => {
                // for the nearest point y and the extreme vertex w: (y · y − y · w) / y · y
                let level = dot(simplex.nearest(), simplex.vertex());
                let excess = &level - &dot(simplex.nearest(), &vertex);
                let is_nearest = !excess.sign().is_gt();
                let width = if is_nearest { 0.0 } else { excess.ratio(&level).sqrt() };
                cone.ball = (width + EXACT_DIRECTION_ROUNDING) * euclidean_norm(&cone.center);
                if is_nearest || width * (query.len() as f64) < CROSSING_COUNT {
                    return cone;
                }
                simplex.add(vertex);
            }
        }
        let nearest = simplex.as_ref().expect("the first step made a simplex").nearest();
        cone.center = rounded_direction(&negated(nearest.clone()));
    }
    cone
}

/// A multiple of a vector by a power of two whose largest coordinate is about 1.
fn unit_sized(v: [f64; 3]) -> [f64; 3] {
    let scale = PowerOfTwo::new(-binary_exponent(max_norm(&v)).map_or(0, i64::from));
    v.map(|c| scale.apply(c))
}

/// The cone that simplices of extreme vertices lead to, in doubles, from the vertex that is extreme in a direction;
/// `None` if rounding hides the direction.
pub(super) fn approach(
    vertices: &mut RoundedVertices<'_>,
    start: [f64; 3],
    first: Extreme,
    tally: &mut dyn Tally,
) -> Option<DirectionCone> {
    let mut simplex = NearestSimplex::<3>::new();
    let (mut direction, mut first) = (start, Some(first));
    let mut last: Option<([f64; 3], f64)> = None;
    let mut known: Option<DirectionCone> = None;
    // where it ends early, a cone that many generators cross is no answer
    let widest = WIDEST_CROSSING_COUNT / vertices.read_count() as f64;
    let narrow = |known: Option<DirectionCone>| known.filter(|cone| cone.ball < widest * euclidean_norm(&cone.center));
    for _ in 0..STEPS {
        let Extreme { vertex, rounding } = first.take().unwrap_or_else(|| vertices.extreme(&direction, tally));
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
                let center = unit_sized(nearest.map(|c| -c));
                let cone =
                    DirectionCone { center, axes: None, ball: (off + rounding) / length * euclidean_norm(&center) };
                known = Some(cone);
                vertices.narrow(&cone);
            }
            if off == 0.0 {
                return known;
            }
        }
        let Some(nearest) = simplex.add(vertex) else { return narrow(known) };
        let square = dot(&nearest, &nearest);
        let is_nearer = last.is_none_or(|(_, last)| square < last);
        if simplex.is_full() || !is_nearer || !square.is_normal() {
            return narrow(known);
        }
        direction = nearest.map(|c| -c);
        last = Some((nearest, square));
    }
    narrow(known)
}
