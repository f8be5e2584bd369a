//! Directions spread evenly over the half sphere, the same ones every time, in blocks of eight.
//!
//! On each face of a cube a sequence of points x + k α mod 1, with multiples of a generalised golden ratio, is as even
//! as a grid for any number of points, and unlike a grid has no rows that a body's symmetries could fall into. The face
//! is warped by a tangent, so that its points spread more evenly over the sphere, and a point has the solid angle that
//! is left to it as its weight.

use crate::numeric::lanes::octet::LANES;
use crate::numeric::linear::dot;

/// Unit vectors of the first `rank` coordinates, 0 in the others, each coordinate of a block side by side.
pub(super) struct SampledDirections<const D: usize> {
    pub(super) blocks: Vec<[[f64; LANES]; D]>,
    /// The solid angle of each, up to a common factor.
    pub(super) weights: Vec<[f64; LANES]>,
}

impl<const D: usize> SampledDirections<D> {
    /// At least `count` directions.
    pub(super) fn new(rank: usize, count: usize) -> Self {
        let steps = steps(rank.saturating_sub(1));
        let mut blocks = Vec::with_capacity(count.div_ceil(LANES));
        let mut weights = Vec::with_capacity(blocks.capacity());
        for first in (0..count).step_by(LANES) {
            let (mut block, mut row) = ([[0.0; LANES]; D], [0.0; LANES]);
            for lane in 0..LANES {
                let (direction, weight) = direction::<D>(rank, &steps, first + lane);
                row[lane] = weight;
                block.iter_mut().zip(direction).for_each(|(coordinate, c)| coordinate[lane] = c);
            }
            blocks.push(block);
            weights.push(row);
        }
        Self { blocks, weights }
    }

    /// The directions one by one.
    pub(super) fn iter(&self) -> impl Iterator<Item = [f64; D]> + '_ {
        self.blocks.iter().flat_map(|block| (0..LANES).map(|lane| std::array::from_fn(|k| block[k][lane])))
    }
}

/// The steps of the sequence along each coordinate of a face: powers of 1 / φ, where φ^(d + 1) = φ + 1.
fn steps(dimension: usize) -> Vec<f64> {
    let mut ratio = 1.5f64;
    for _ in 0..64 {
        ratio = libm::pow(1.0 + ratio, 1.0 / (dimension as f64 + 1.0));
    }
    std::iter::successors(Some(1.0 / ratio), |step| Some(step / ratio)).take(dimension).collect()
}

fn direction<const D: usize>(rank: usize, steps: &[f64], index: usize) -> ([f64; D], f64) {
    let (face, turn) = (index % rank, (index / rank + 1) as f64);
    let (mut u, mut density) = ([0.0; D], 1.0);
    u[face] = 1.0;
    for (axis, step) in (0..rank).filter(|axis| *axis != face).zip(steps) {
        let part = 0.5 + turn * step;
        let along = 2.0 * (part - part.floor()) - 1.0;
        u[axis] = libm::tan(std::f64::consts::FRAC_PI_4 * along);
        density *= 1.0 + u[axis] * u[axis];
    }
    let length = dot(&u, &u).sqrt();
    // by products: a power of the standard library may have other last bits on another machine
    (u.map(|c| c / length), (0..rank).fold(density, |weight, _| weight / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_even() {
        // the means of |u_1| over the half sphere in two, three and four dimensions
        for (rank, mean) in [(2, std::f64::consts::FRAC_2_PI), (3, 0.5), (4, 0.424_413_18)] {
            let directions = SampledDirections::<4>::new(rank, 4096);
            for axis in 0..rank {
                let (mut sum, mut total) = (0.0, 0.0);
                for (block, weights) in directions.blocks.iter().zip(&directions.weights) {
                    sum += block[axis].iter().zip(weights).map(|(c, w)| c.abs() * w).sum::<f64>();
                    total += weights.iter().sum::<f64>();
                }
                assert!((sum / total - mean).abs() < 3e-3, "rank {rank}, axis {axis}: {}", sum / total);
            }
        }
        assert!(SampledDirections::<2>::new(1, 9).iter().all(|u| u == [1.0, 0.0]));
    }
}
