//! Degenerate inputs: an exactly symmetric hull, few distinct points, and points on one line.

use super::family::{Family, HullSize};
use crate::source::RandomSource;

/// Pairs of points p and -p: the optimal zonogon is the hull itself.
pub const SYMMETRIC: Family = Family {
    id: "symmetric",
    title: "Centrally symmetric",
    description: "points on the unit circle in exact pairs p, -p (and the origin when n is odd)",
    hull_size: HullSize::NearlyAll,
    is_random: true,
    generate: symmetric,
};

/// About sqrt(n) distinct Gaussian points, each repeated many times.
pub const DUPLICATES: Family = Family {
    id: "duplicates",
    title: "Duplicates",
    description: "n draws, with repetition, from about sqrt(n) distinct Gaussian points",
    hull_size: HullSize::Few,
    is_random: true,
    generate: duplicates,
};

/// Points on one line through the origin, exactly.
pub const COLLINEAR: Family = Family {
    id: "collinear",
    title: "Collinear",
    description: "points (3k, 2k) for random integers k below 2^40: exactly on one line",
    hull_size: HullSize::Flat,
    is_random: true,
    generate: collinear,
};

fn symmetric(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    let half: Vec<_> = (0..n / 2).map(|_| source.unit_vector()).collect();
    let mut points: Vec<_> = half.iter().flat_map(|&[x, y]| [[x, y], [-x, -y]]).collect();
    points.resize(n, [0.0, 0.0]);
    points
}

fn duplicates(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    let distinct: Vec<_> = (0..n.isqrt().max(1)).map(|_| source.normal_pair()).collect();
    (0..n).map(|_| distinct[source.below(distinct.len())]).collect()
}

fn collinear(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let k = (source.bits() >> 24) as f64;
            [3.0 * k, 2.0 * k]
        })
        .collect()
}
