//! Points on an ellipse: the circle family, squeezed along the y axis. All lines of 4.1 nearly meet in the centre.

use super::family::{Family, HullSize};
use crate::source::RandomSource;

/// Points on the ellipse with half-axes 1 and 1/4.
pub const ELLIPSE: Family = Family {
    id: "ellipse",
    title: "Ellipse 4 : 1",
    description: "points on the ellipse with half-axes 1 and 1/4, at uniform parameter angles",
    hull_size: HullSize::NearlyAll,
    is_random: true,
    generate: |n, seed| points(n, seed, 0.25),
};

/// Points on the ellipse with half-axes 1 and 1/100.
pub const ELLIPSE_THIN: Family = Family {
    id: "ellipse_thin",
    title: "Ellipse 100 : 1",
    description: "points on the ellipse with half-axes 1 and 1/100, at uniform parameter angles",
    hull_size: HullSize::NearlyAll,
    is_random: true,
    generate: |n, seed| points(n, seed, 0.01),
};

/// `n` points on the ellipse with half-axes 1 and `axis_ratio`, at independent uniform parameter angles.
pub fn points(n: usize, seed: u64, axis_ratio: f64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let [x, y] = source.unit_vector();
            [x, axis_ratio * y]
        })
        .collect()
}
