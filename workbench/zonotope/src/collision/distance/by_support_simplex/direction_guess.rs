//! A cone of directions that probably holds the direction from the nearest point, in doubles: nothing but speed depends
//! on it.
//!
//! It is the search of [`by_gjk`](crate::collision::by_gjk), which goes on until the nearest point is known: let y be
//! the point of a simplex nearest to the displacement, seen from the displacement, and w the extreme vertex in the
//! direction −y. The nearest point of the body is no farther from y than √(y · y − y · w), which bounds the angle
//! between the directions to both. As soon as that angle is small, generators whose sign is fixed in the cone are
//! summed up once and for all, and the passes that follow read the others alone.

use crate::collision::by_gjk::nearest::Simplex;
use crate::lad::of_generators::cells::direction_cone::DirectionCone;
use crate::lad::of_generators::cells::sign_pass::{FixedSum, Places};
use crate::lad::of_generators::generators::KernelQuery;
use crate::numeric::exact_linear::{exact, rounded_direction};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{dot, euclidean_norm, max_norm};
use crate::numeric::scaling::{PowerOfTwo, binary_exponent};
use crate::numeric::tolerance::{CONTACT_ANGLE, NEAREST_POINT_ROUNDING, SEPARATING_DIRECTION_DOUBT};
use crate::tally::{Operation, Tally};

/// The most extreme vertices that are looked at.
const STEPS: u32 = 128;

/// Generators are summed up where the cone is at most this wide, and a later cone is this much narrower than the last.
const NARROWING: f64 = 1.0 / 16.0;

/// No generators are summed up where there are at most this many.
const WORTHWHILE_COUNT: usize = 64;

/// What a step reads: all generators of the query, or those that cross a cone and the sum of the others.
struct Reading<'q> {
    query: &'q dyn KernelQuery,
    narrowed: Option<(FixedSum, Vec<[f64; 3]>, f64)>,
}

impl Reading<'_> {
    fn len(&self) -> usize {
        self.narrowed.as_ref().map_or(self.query.len(), |(_, vectors, _)| vectors.len())
    }

    /// The sum of the generators whose sign is fixed in a cone, and the other ones.
    fn split(&self, cone: &DirectionCone) -> (FixedSum, Vec<[f64; 3]>) {
        let mut places = Places::new();
        match &self.narrowed {
            None => {
                let mut crossing = Vec::new();
                (self.query.split(cone, &mut crossing, &mut places), crossing)
            }
            Some((fixed, vectors, _)) => {
                let sum = cone.split(Rows::new(vectors), &mut places);
                (fixed.plus(&sum), places.iter().map(|&place| vectors[place as usize]).collect())
            }
        }
    }

    /// The extreme vertex in a direction, and the lengths of all generators.
    fn extreme(&self, direction: &[f64; 3]) -> ([f64; 3], f64) {
        let (fixed, crossing) = self.split(&DirectionCone { center: *direction, axes: None, ball: 0.0 });
        let vertex = crossing.iter().fold(fixed.sum, |sum, v| {
            let sign = f64::copysign(1.0, dot(v, direction));
            [0, 1, 2].map(|k| sum[k] + sign * v[k])
        });
        (vertex, fixed.magnitude)
    }

    /// Reads from now on the generators that cross a cone alone, if the cone is narrow enough to make that worth it.
    fn narrow(&mut self, cone: &DirectionCone) {
        let width = cone.ball / euclidean_norm(&cone.center);
        let last = self.narrowed.as_ref().map_or(1.0, |(_, _, width)| *width);
        if width <= NARROWING * last && self.len() > WORTHWHILE_COUNT {
            let (fixed, crossing) = self.split(cone);
            self.narrowed = Some((fixed, crossing, width));
        }
    }
}

/// A cone around the direction from the nearest point, as far as doubles know it; `start` is a direction in which the
/// displacement is beyond the body, and what is known where the bodies are so near to each other that the vector
/// between them is lost to rounding.
pub(super) fn cone(query: &dyn KernelQuery, start: [f64; 3], tally: &mut dyn Tally) -> DirectionCone {
    let p = query.rounded_displacement().map(|c| c.value);
    let mut reading = Reading { query, narrowed: None };
    let mut simplex = Simplex::<3>::new();
    let mut direction = start;
    let mut scale: Option<PowerOfTwo> = None;
    let mut last: Option<([f64; 3], f64)> = None;
    let mut known = DirectionCone { center: start, axes: None, ball: SEPARATING_DIRECTION_DOUBT };
    for _ in 0..STEPS {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, reading.len() as u64);
        let (extreme, magnitude) = reading.extreme(&direction);
        let vertex = [0, 1, 2].map(|k| extreme[k] - p[k]);
        let size = max_norm(&vertex).max(max_norm(&p));
        let scale = scale.get_or_insert_with(|| PowerOfTwo::new(-binary_exponent(size).map_or(0, i64::from)));
        let vertex = vertex.map(|c| scale.apply(c));
        let rounding = NEAREST_POINT_ROUNDING * scale.apply(magnitude + max_norm(&p));
        if let Some((nearest, square)) = last {
            let length = square.sqrt();
            let excess = square - dot(&nearest, &vertex);
            // where no vertex is farther but for rounding, the point is off by rounding alone
            let off = if excess <= rounding * length { 0.0 } else { excess.sqrt() };
            // false for NaN as well
            let is_known = rounding < CONTACT_ANGLE * length && off < length;
            if is_known {
                let center = rounded_direction(&exact(nearest.map(|c| -c)));
                let ball = (off + rounding) / length * euclidean_norm(&center);
                known = DirectionCone { center, axes: None, ball };
                reading.narrow(&known);
            }
            if off == 0.0 {
                break;
            }
        }
        let Some(nearest) = simplex.add(vertex) else { break };
        let square = dot(&nearest, &nearest);
        let is_nearer = last.is_none_or(|(_, last)| square < last);
        if simplex.is_full() || !is_nearer || !square.is_normal() {
            break;
        }
        direction = nearest.map(|c| -c);
        last = Some((nearest, square));
    }
    known
}
