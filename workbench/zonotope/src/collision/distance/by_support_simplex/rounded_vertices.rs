//! Extreme vertices of a zonotope as seen from a displacement, in doubles of ordinary size.

use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Part;
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places, USUAL_CROSSING};
use crate::numeric::lanes::extreme_sum;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{dot, euclidean_norm, max_norm};
use crate::numeric::scaling::{PowerOfTwo, binary_exponent};
use crate::numeric::tolerance::NEAREST_POINT_ROUNDING;
use crate::tally::{Operation, Tally};

/// Generators are summed up where the cone is at most this wide, and a later cone is this much narrower than the last.
const NARROWING: f64 = 1.0 / 64.0;

/// No generators are summed up where there are at most this many.
const WORTHWHILE_COUNT: usize = 64;

/// A gap that is at least this part of the displacement is no near contact.
const LEAST_CLEAR_GAP: f64 = 1.0 / 128.0;

/// An extreme vertex as seen from the displacement, in units of the displacement's size.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extreme {
    pub(super) vertex: [f64; 3],
    /// The distance by which rounding may move nearest points of simplices of such vertices.
    pub(super) rounding: f64,
}

/// Sums in doubles. As soon as directions are known to be in a narrow cone, the generators whose sign is fixed in it
/// are summed up once and for all, and the passes that follow read the others alone.
pub(super) struct RoundedVertices<'q> {
    query: &'q dyn KernelQuery,
    p: [f64; 3],
    /// The sum of the generators that miss the cone, the others, and the width of the cone.
    narrowed: Option<(FixedSum, Vec<[f64; 3]>, f64)>,
    /// Σ |v| over all generators, or a little more.
    magnitude: f64,
    scale: Option<PowerOfTwo>,
}

impl<'q> RoundedVertices<'q> {
    pub(super) fn new(query: &'q dyn KernelQuery) -> Self {
        let p = query.rounded_displacement().map(|c| c.value);
        let magnitude = query.parts().iter().map(Part::magnitude).sum();
        Self { query, p, narrowed: None, magnitude, scale: None }
    }

    /// The sum of the generators whose sign is fixed in a cone, and the other ones.
    fn split(&self, cone: &DirectionCone) -> (FixedSum, Vec<[f64; 3]>) {
        let mut places = Places::with_capacity(USUAL_CROSSING);
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

    /// How many generators a vertex is summed up from.
    pub(super) fn read_count(&self) -> usize {
        self.narrowed.as_ref().map_or(self.query.len(), |(_, vectors, _)| vectors.len())
    }

    /// The extreme vertex in a direction.
    pub(super) fn extreme(&mut self, direction: &[f64; 3], tally: &mut dyn Tally) -> Extreme {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, self.read_count() as u64);
        let sum = match &self.narrowed {
            None => self.query.extreme_sum(direction),
            Some((fixed, vectors, _)) => {
                let own = extreme_sum(vectors, direction);
                [0, 1, 2].map(|k| fixed.sum[k] + own[k])
            }
        };
        let vertex = [0, 1, 2].map(|k| sum[k] - self.p[k]);
        let size = max_norm(&vertex).max(max_norm(&self.p));
        let scale = self.scale.get_or_insert_with(|| PowerOfTwo::new(-binary_exponent(size).map_or(0, i64::from)));
        let rounding = NEAREST_POINT_ROUNDING * scale.apply(self.magnitude + max_norm(&self.p));
        Extreme { vertex: vertex.map(|c| scale.apply(c)), rounding }
    }

    /// Whether the displacement is far beyond the body in a direction, in terms of its own length, by the vertex that
    /// is extreme there.
    pub(super) fn is_far(&self, direction: &[f64; 3], extreme: &Extreme) -> bool {
        let size = self.scale.as_ref().map_or(f64::INFINITY, |scale| scale.apply(max_norm(&self.p)));
        -dot(direction, &extreme.vertex) > LEAST_CLEAR_GAP * size * euclidean_norm(direction)
    }

    /// From now on directions are in a cone.
    pub(super) fn narrow(&mut self, cone: &DirectionCone) {
        let width = cone.ball / euclidean_norm(&cone.center);
        let last = self.narrowed.as_ref().map_or(1.0, |(_, _, width)| *width);
        if width <= NARROWING * last && self.read_count() > WORTHWHILE_COUNT {
            let (fixed, crossing) = self.split(cone);
            self.narrowed = Some((fixed, crossing, width));
        }
    }
}
