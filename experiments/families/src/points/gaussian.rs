//! Independent standard normal points; about sqrt(log n) of them lie on the hull.

use super::family::{Family, HullSize};
use crate::source::RandomSource;

/// Independent standard normal points.
pub const GAUSSIAN: Family = Family {
    id: "gaussian",
    title: "Gaussian",
    description: "independent points from the standard normal distribution in the plane",
    hull_size: HullSize::Few,
    is_random: true,
    generate: points,
};

fn points(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    (0..n).map(|_| source.normal_pair()).collect()
}
