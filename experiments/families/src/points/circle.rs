//! Points on the unit circle at independent uniform angles.

use super::family::{Family, HullSize};
use crate::source::RandomSource;

/// Points on the unit circle at independent uniform angles.
pub const CIRCLE: Family = Family {
    id: "circle",
    title: "Circle",
    description: "points on the unit circle at independent uniform angles, rounded to doubles",
    hull_size: HullSize::NearlyAll,
    is_random: true,
    generate: points,
};

fn points(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    (0..n).map(|_| source.unit_vector()).collect()
}
