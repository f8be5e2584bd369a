//! Independent uniform points of the unit disc; about n^(1/3) of them lie on the hull.

use super::family::{Family, HullSize};
use crate::source::RandomSource;

/// Independent uniform points of the unit disc.
pub const DISC: Family = Family {
    id: "disc",
    title: "Disc",
    description: "independent uniform points of the unit disc",
    hull_size: HullSize::Few,
    is_random: true,
    generate: points,
};

fn points(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    (0..n).map(|_| source.disc_point()).collect()
}
