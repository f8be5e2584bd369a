//! Generators of very uneven lengths.

use super::family::BodyFamily;
use super::random::unit_vector;
use crate::source::RandomSource;

/// Lengths without a finite mean.
pub const HEAVY_TAILED_BODIES: BodyFamily<3> = BodyFamily {
    id: "heavy_tailed_bodies",
    title: "Heavy-tailed bodies",
    description: "uniform directions, length 1 / u for u uniform in (0, 1]: the mean is infinite",
    is_random: true,
    generate: heavy_tailed,
};

/// Lengths over four hundred binary orders.
pub const WIDE_SCALES_BODIES: BodyFamily<3> = BodyFamily {
    id: "wide_scales_bodies",
    title: "Wide scales",
    description: "uniform directions, length 2^k for k uniform in -200 ..= 200",
    is_random: true,
    generate: wide_scales,
};

const LARGEST_EXPONENT: usize = 200;

fn heavy_tailed(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let direction = unit_vector(&mut source);
            let length = 1.0 / (1.0 - source.unit());
            direction.map(|c| length * c)
        })
        .collect()
}

fn wide_scales(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let direction = unit_vector(&mut source);
            let exponent = source.below(2 * LARGEST_EXPONENT + 1) as i32 - LARGEST_EXPONENT as i32;
            direction.map(|c| libm::ldexp(c, exponent))
        })
        .collect()
}
