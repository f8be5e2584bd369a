//! Extreme vertices of a zonotope as seen from a displacement, in doubles of ordinary size.

use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places, USUAL_CROSSING};
use crate::numeric::lanes::extreme_sum;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{euclidean_norm, max_norm};
use crate::numeric::scaling::{PowerOfTwo, binary_exponent};
use crate::numeric::tolerance::NEAREST_POINT_ROUNDING;

/// Generators are summed up where the cone is at most this wide, and a later cone is this much narrower than the last.
const NARROWING: f64 = 1.0 / 16.0;

/// No generators are summed up where there are at most this many.
const WORTHWHILE_COUNT: usize = 64;

/// Sums in doubles. As soon as directions are known to be in a narrow cone, the generators whose sign is fixed in it
/// are summed up once and for all, and the passes that follow read the others alone.
pub(super) struct RoundedVertices<'q> {
    query: &'q dyn KernelQuery,
    p: [f64; 3],
    /// The sum of the generators that miss the cone, the others, and the width of the cone.
    narrowed: Option<(FixedSum, Vec<[f64; 3]>, f64)>,
    /// At least Σ |v| over all generators.
    magnitude: Option<f64>,
    scale: Option<PowerOfTwo>,
}

impl<'q> RoundedVertices<'q> {
    pub(super) fn new(query: &'q dyn KernelQuery) -> Self {
        let p = query.rounded_displacement().map(|c| c.value);
        Self { query, p, narrowed: None, magnitude: None, scale: None }
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

    /// The sum of the generators with the signs of their products with a direction.
    fn extreme_sum(&mut self, direction: &[f64; 3]) -> [f64; 3] {
        let Some((fixed, vectors, _)) = &self.narrowed else {
            if self.magnitude.is_none() {
                // the pass of a cone tells the magnitude as well
                let (fixed, crossing) = self.split(&DirectionCone { center: *direction, axes: None, ball: 0.0 });
                self.magnitude = Some(fixed.magnitude);
                return plus_extreme(fixed.sum, &crossing, direction);
            }
            return self.query.extreme_sum(direction);
        };
        plus_extreme(fixed.sum, vectors, direction)
    }

    /// The extreme vertex in a direction, and what nearest points of simplices of such vertices are off by rounding.
    pub(super) fn extreme(&mut self, direction: &[f64; 3]) -> ([f64; 3], f64) {
        let sum = self.extreme_sum(direction);
        let magnitude = self.magnitude.expect("the first sum tells the magnitude");
        let vertex = [0, 1, 2].map(|k| sum[k] - self.p[k]);
        let size = max_norm(&vertex).max(max_norm(&self.p));
        let scale = self.scale.get_or_insert_with(|| PowerOfTwo::new(-binary_exponent(size).map_or(0, i64::from)));
        let rounding = NEAREST_POINT_ROUNDING * scale.apply(magnitude + max_norm(&self.p));
        (vertex.map(|c| scale.apply(c)), rounding)
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

/// A vector, and the sum of some generators with the signs of their products with a direction.
fn plus_extreme(sum: [f64; 3], generators: &[[f64; 3]], direction: &[f64; 3]) -> [f64; 3] {
    let own = extreme_sum(generators, direction);
    [0, 1, 2].map(|k| sum[k] + own[k])
}
