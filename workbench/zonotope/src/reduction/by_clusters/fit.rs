//! The fit of a few generators to a body: the largest difference of the support functions is made small.
//!
//! The support functions are compared along sampled directions and along facet normals of the fitted zonotope, which is
//! where it is narrowest beside its neighbourhood. A zonotope that reaches farther than the body by between 0 and ε
//! everywhere is within ε of it; so the difference should be near ε / 2 everywhere. The sum of powers of
//! |difference − ε / 2| is smooth but for kinks that average out, and with a rising power it turns from the mean of the
//! squares to the largest difference. Between minimisations ε, the power and the normals are taken anew.

use super::super::containment::Facets;
use super::quasi_newton::minimize;
use super::sampled_directions::{LANES, SampledDirections};
use crate::numeric::lanes::absolute_sum;
use crate::numeric::linear::dot;

/// Sampled directions for each generator, and as many facet normals: the difference changes over the width of a cluster,
/// which some directions have to cover.
const DIRECTIONS_PER_GENERATOR: usize = 32;

/// The same where there are many generators.
const DIRECTIONS_PER_GENERATOR_OF_MANY: usize = 16;

/// Generators from which on there are many.
const MANY_GENERATORS: usize = 256;

/// Facet normals among which the directions of a stage are chosen, at most.
const NORMAL_LIMIT: u64 = 1 << 14;

/// Minimisations one after the other, each of a number of steps.
const STAGES: usize = 20;
const STEPS_PER_STAGE: usize = 15;

/// The last power.
const LARGEST_POWER: i32 = 16;

/// A difference below this part of the body's width is rounding.
const NEGLIGIBLE_ERROR: f64 = 1e-12;

/// Directions with the body's support function.
struct Comparison<const D: usize> {
    blocks: Vec<[[f64; LANES]; D]>,
    weights: Vec<[f64; LANES]>,
    body: Vec<[f64; LANES]>,
}

/// The differences of two support functions.
struct Range {
    /// The factor by which the fitted zonotope has to grow to reach as far as the body.
    growth: f64,
    /// By how much it reaches farther then at most.
    error: f64,
    /// Half of the difference of the largest and the least difference.
    half_width: f64,
}

impl<const D: usize> Comparison<D> {
    fn new(body: &[[f64; D]], directions: SampledDirections<D>) -> Self {
        let values: Vec<f64> = directions.iter().map(|u| absolute_sum(body, &u)).collect();
        let body = values.as_chunks().0.to_vec();
        Self { blocks: directions.blocks, weights: directions.weights, body }
    }

    /// The same with further directions, whose weights together are those of the sampled ones.
    fn with(&self, directions: &[([f64; D], f64)]) -> Self {
        let total: f64 = self.weights.iter().flatten().sum();
        let mut all = Self { blocks: self.blocks.clone(), weights: self.weights.clone(), body: self.body.clone() };
        for chunk in directions.chunks(LANES) {
            // a last block is filled up with its own directions
            let full: [([f64; D], f64); LANES] = std::array::from_fn(|lane| chunk[lane % chunk.len()]);
            all.blocks.push(std::array::from_fn(|k| full.map(|(u, _)| u[k])));
            all.weights.push([total / directions.len() as f64; LANES]);
            all.body.push(full.map(|(_, value)| value));
        }
        all
    }

    fn range(&self, generators: &[[f64; D]]) -> Range {
        let mut growth = 0.0f64;
        let [mut least, mut most] = [f64::INFINITY, f64::NEG_INFINITY];
        let mut fitted = Vec::with_capacity(self.body.len());
        for (block, body) in self.blocks.iter().zip(&self.body) {
            let mut reach = [0.0; LANES];
            for b in generators {
                let products = products(b, block);
                (0..LANES).for_each(|lane| reach[lane] += products[lane].abs());
            }
            for (reach, body) in reach.iter().zip(body) {
                if *body > growth * reach {
                    growth = body / reach;
                }
                (least, most) = (least.min(reach - body), most.max(reach - body));
            }
            fitted.push(reach);
        }
        let pairs = fitted.iter().flatten().zip(self.body.iter().flatten());
        let error = pairs.fold(0.0f64, |error, (reach, body)| error.max(growth * reach - body));
        Range { growth, error, half_width: (most - least) / 2.0 }
    }

    /// Σ weight · ((difference − middle) / half width)^power and its gradient, in `lanes` before it is summed up.
    fn objective(
        &self,
        generators: &[f64],
        [middle, half_width]: [f64; 2],
        power: i32,
        lanes: &mut [[[f64; LANES]; D]],
        gradient: &mut [f64],
    ) -> f64 {
        let generators = generators.as_chunks::<D>().0;
        lanes.fill([[0.0; LANES]; D]);
        let mut along = vec![[0.0; LANES]; generators.len()];
        let mut sum = [0.0; LANES];
        for ((block, weights), body) in self.blocks.iter().zip(&self.weights).zip(&self.body) {
            let mut reach = [0.0; LANES];
            for (b, along) in generators.iter().zip(&mut along) {
                *along = products(b, block);
                (0..LANES).for_each(|lane| reach[lane] += along[lane].abs());
            }
            let mut slopes = [0.0; LANES];
            for lane in 0..LANES {
                let part = (reach[lane] - body[lane] - middle) / half_width;
                let lower = weights[lane] * part.powi(power - 1);
                sum[lane] += lower * part;
                slopes[lane] = lower * (f64::from(power) / half_width);
            }
            for (along, lanes) in along.iter().zip(lanes.iter_mut()) {
                let signed: [f64; LANES] =
                    std::array::from_fn(|lane| if along[lane] < 0.0 { -slopes[lane] } else { slopes[lane] });
                for (coordinate, lanes) in block.iter().zip(lanes) {
                    (0..LANES).for_each(|lane| lanes[lane] += signed[lane] * coordinate[lane]);
                }
            }
        }
        for (slope, lanes) in gradient.iter_mut().zip(lanes.as_flattened()) {
            *slope = lanes.iter().sum();
        }
        sum.iter().sum()
    }
}

#[inline(always)]
fn products<const D: usize>(b: &[f64; D], block: &[[f64; LANES]; D]) -> [f64; LANES] {
    let mut products = [0.0; LANES];
    for (c, coordinate) in b.iter().zip(block) {
        (0..LANES).for_each(|lane| products[lane] += c * coordinate[lane]);
    }
    products
}

/// Generators whose zonotope reaches as far as that of `body` along the directions that were compared, and little
/// farther. Both are 0 beyond the first `rank` coordinates.
pub(super) fn fitted<const D: usize>(body: &[[f64; D]], rank: usize, start: Vec<[f64; D]>) -> Vec<[f64; D]> {
    let per_generator = match start.len() < MANY_GENERATORS {
        true => DIRECTIONS_PER_GENERATOR,
        false => DIRECTIONS_PER_GENERATOR_OF_MANY,
    };
    let count = per_generator * start.len();
    let sampled = Comparison::new(body, SampledDirections::new(rank, count.next_multiple_of(LANES)));
    let width = sampled.body.iter().flatten().fold(0.0f64, |width, value| width.max(*value));
    let mut lanes = vec![[[0.0; LANES]; D]; start.len()];
    let mut generators = start;
    let mut best = (f64::INFINITY, generators.clone());
    for stage in 0..=STAGES {
        let compared = sampled.with(&narrowest_normals(body, rank, &generators, count, stage));
        let range = compared.range(&generators);
        if range.error < best.0 && range.growth.is_finite() {
            best = (range.error, generators.iter().map(|b| b.map(|c| c * range.growth)).collect());
        }
        if stage == STAGES || range.half_width <= NEGLIGIBLE_ERROR * width || !range.error.is_finite() {
            break;
        }
        let middle = if stage == 0 { 0.0 } else { range.error / 2.0 };
        let power = LARGEST_POWER.min(2 + 2 * (stage as i32 * 3 / 5));
        let mut point = generators.as_flattened().to_vec();
        minimize(&mut point, STEPS_PER_STAGE, 0.1 * range.half_width, |point, gradient| {
            compared.objective(point, [middle, range.half_width], power, &mut lanes, gradient)
        });
        generators = point.as_chunks::<D>().0.to_vec();
    }
    best.1
}

/// Facet normals of the zonotope along which it reaches least beyond the body, with the body's support function.
fn narrowest_normals<const D: usize>(
    body: &[[f64; D]],
    rank: usize,
    generators: &[[f64; D]],
    count: usize,
    stage: usize,
) -> Vec<([f64; D], f64)> {
    let Some(facets) = Facets::new(generators, rank) else { return Vec::new() };
    let mut normals: Vec<(f64, [f64; D], f64)> = Vec::new();
    facets.for_sampled_normals(NORMAL_LIMIT, stage as u64, |normal| {
        let length = dot(&normal, &normal).sqrt();
        let normal = normal.map(|c| c / length);
        let (reach, limit) = (absolute_sum(body, &normal), absolute_sum(generators, &normal));
        if (limit - reach).is_finite() {
            normals.push((limit - reach, normal, reach));
        }
    });
    normals.sort_by(|a, b| a.0.total_cmp(&b.0));
    normals.truncate(count);
    normals.into_iter().map(|(_, normal, reach)| (normal, reach)).collect()
}
