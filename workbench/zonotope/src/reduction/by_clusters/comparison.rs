//! The support functions of a body and of a few generators side by side, along many directions.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::sampled_directions::SampledDirections;
use crate::numeric::lanes::absolute_sum;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, total, turned};

/// Directions with the body's support function, eight side by side.
#[derive(Debug, Clone)]
pub(super) struct Comparison<const D: usize> {
    blocks: Vec<[[f64; LANES]; D]>,
    weights: Vec<[f64; LANES]>,
    body: Vec<[f64; LANES]>,
}

/// The differences of two support functions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Range {
    /// The factor by which the zonotope of the generators has to grow to reach as far as the body.
    pub(super) growth: f64,
    /// By how much it reaches farther then at most.
    pub(super) error: f64,
    /// Half of the difference of the largest and the least difference.
    pub(super) half_width: f64,
}

/// What the differences are measured by: their middle, their half width, and the even power that is summed up.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measure {
    pub(super) middle: f64,
    pub(super) half_width: f64,
    pub(super) power: u32,
}

impl<const D: usize> Comparison<D> {
    /// A body along sampled directions. O(n) a direction.
    pub(super) fn new(body: &[[f64; D]], directions: SampledDirections<D>) -> Self {
        let values: Vec<f64> = directions.iter().map(|u| absolute_sum(body, &u)).collect();
        let body = values.as_chunks().0.to_vec();
        Self { blocks: directions.blocks, weights: directions.weights, body }
    }

    /// The same with further directions and the body's support function there; they weigh as much as the others.
    pub(super) fn with(&self, directions: &[([f64; D], f64)]) -> Self {
        let total: f64 = self.weights.iter().flatten().sum();
        let mut all = self.clone();
        for chunk in directions.chunks(LANES) {
            // a last block is filled up with its own directions
            let full: [([f64; D], f64); LANES] = std::array::from_fn(|lane| chunk[lane % chunk.len()]);
            all.blocks.push(std::array::from_fn(|k| full.map(|(u, _)| u[k])));
            all.weights.push([total / directions.len() as f64; LANES]);
            all.body.push(full.map(|(_, value)| value));
        }
        all
    }

    /// The largest value of the body's support function.
    pub(super) fn largest(&self) -> f64 {
        self.body.iter().flatten().fold(0.0f64, |largest, value| largest.max(*value))
    }

    /// The differences of the support function of generators to the body's.
    pub(super) fn range(&self, generators: &[[f64; D]]) -> Range {
        let mut growth = 0.0f64;
        let [mut least, mut most] = [f64::INFINITY, f64::NEG_INFINITY];
        let mut pairs = Vec::with_capacity(self.body.len() * LANES);
        for (block, body) in self.blocks.iter().zip(&self.body) {
            let mut reach = [0.0; LANES];
            for b in generators {
                for lane in 0..LANES {
                    reach[lane] += (0..D).map(|k| b[k] * block[k][lane]).sum::<f64>().abs();
                }
            }
            for (reach, body) in reach.into_iter().zip(body) {
                if *body > growth * reach {
                    growth = body / reach;
                }
                (least, most) = (least.min(reach - body), most.max(reach - body));
                pairs.push((reach, *body));
            }
        }
        let error = pairs.iter().fold(0.0f64, |error, (reach, body)| error.max(growth * reach - body));
        Range { growth, error, half_width: (most - least) / 2.0 }
    }

    /// Σ weight · ((difference − middle) / half width)^power, and its gradient by the generators' coordinates.
    pub(super) fn objective(&self, generators: &[[f64; D]], measure: Measure, gradient: &mut [f64]) -> f64 {
        let mut slopes = vec![[[0.0; LANES]; D]; generators.len()];
        let value = dispatch!(level(), simd => objective(simd, self, generators, measure, &mut slopes));
        let factor = f64::from(measure.power) / measure.half_width;
        for (slope, lanes) in gradient.iter_mut().zip(slopes.as_flattened()) {
            *slope = factor * lanes.iter().sum::<f64>();
        }
        value
    }
}

/// Blocks of directions that are read together: their coordinates stay in registers while the generators pass by.
const TILE: usize = 4;

/// The sum, with the gradient in `slopes` but for a factor and before the lanes are added up.
#[inline(always)]
fn objective<S: Simd, const D: usize>(
    simd: S,
    compared: &Comparison<D>,
    generators: &[[f64; D]],
    measure: Measure,
    slopes: &mut [[[f64; LANES]; D]],
) -> f64 {
    slopes.fill([[0.0; LANES]; D]);
    let mut value = f64x8::splat(simd, 0.0);
    let in_tiles = compared.blocks.len() - compared.blocks.len() % TILE;
    for first in (0..in_tiles).step_by(TILE) {
        value += tile::<S, D, TILE>(simd, compared, first, generators, measure, slopes);
    }
    for first in in_tiles..compared.blocks.len() {
        value += tile::<S, D, 1>(simd, compared, first, generators, measure, slopes);
    }
    total(value)
}

/// The part of some blocks.
#[inline(always)]
fn tile<S: Simd, const D: usize, const T: usize>(
    simd: S,
    compared: &Comparison<D>,
    first: usize,
    generators: &[[f64; D]],
    measure: Measure,
    slopes: &mut [[[f64; LANES]; D]],
) -> f64x8<S> {
    let zero = f64x8::splat(simd, 0.0);
    let mut directions = [[zero; D]; T];
    for (direction, block) in directions.iter_mut().zip(&compared.blocks[first..]) {
        for (coordinates, lanes) in direction.iter_mut().zip(block) {
            *coordinates = f64x8::from_slice(simd, lanes);
        }
    }
    let mut reach = [zero; T];
    for b in generators {
        for t in 0..T {
            reach[t] += along(&directions[t], b).abs();
        }
    }
    let (middle, scale) = (f64x8::splat(simd, measure.middle), f64x8::splat(simd, 1.0 / measure.half_width));
    let (mut slope, mut value) = ([zero; T], zero);
    for t in 0..T {
        let part = (reach[t] - f64x8::from_slice(simd, &compared.body[first + t]) - middle) * scale;
        slope[t] = f64x8::from_slice(simd, &compared.weights[first + t]);
        for _ in 1..measure.power {
            slope[t] *= part;
        }
        value += slope[t] * part;
    }
    for (b, slopes) in generators.iter().zip(slopes) {
        let mut sums = [zero; D];
        for t in 0..T {
            let signed = turned(simd, slope[t], along(&directions[t], b));
            for k in 0..D {
                sums[k] += signed * directions[t][k];
            }
        }
        for k in 0..D {
            (f64x8::from_slice(simd, &slopes[k]) + sums[k]).store_slice(&mut slopes[k]);
        }
    }
    value
}

#[inline(always)]
fn along<S: Simd, const D: usize>(direction: &[f64x8<S>; D], b: &[f64; D]) -> f64x8<S> {
    let mut sum = direction[0] * b[0];
    for k in 1..D {
        sum += direction[k] * b[k];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::level::at_each_level;

    #[test]
    fn the_gradient_is_that_of_differences_at_every_level() {
        let body = [[1.0, 0.5, 0.25], [-0.5, 1.0, 2.0], [0.0, 0.0, 1.0], [3.0, -1.0, 1.0]];
        let generators = [[1.5, 0.25, 0.5], [1.0, -2.0, 1.0], [0.5, 0.5, -3.0]];
        let compared = Comparison::new(&body, SampledDirections::new(3, 64));
        let Range { half_width, error, .. } = compared.range(&generators);
        let measure = Measure { middle: error / 2.0, half_width, power: 6 };
        let value = |generators: &[[f64; 3]]| {
            let mut gradient = vec![0.0; 9];
            let value = compared.objective(generators, measure, &mut gradient);
            (value, gradient)
        };
        let results = at_each_level(|| value(&generators));
        assert!(results.iter().all(|result| *result == results[0]));
        for at in 0..9 {
            let moved = |step: f64| {
                let mut moved = generators;
                moved.as_flattened_mut()[at] += step;
                value(&moved).0
            };
            let slope = (moved(1e-6) - moved(-1e-6)) / 2e-6;
            assert!((slope - results[0].1[at]).abs() < 1e-5 * (1.0 + slope.abs()), "{slope}, {}", results[0].1[at]);
        }
    }
}
