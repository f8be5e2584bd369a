//! Generators whose directions are in order, exactly parallel, or nearly so.

use super::family::BodyFamily;
use super::random::{normal_vector, unit_vector};
use crate::source::RandomSource;

/// Normal generators in the order of their first coordinates relative to their second.
pub const SORTED_BODIES: BodyFamily<3> = BodyFamily {
    id: "sorted_bodies",
    title: "Sorted bodies",
    description: "generators with independent standard normal coordinates, turned to point up and sorted by the slope \
        x / z",
    is_random: true,
    generate: sorted,
};

/// Exactly parallel generators in few directions.
pub const PARALLEL_BODIES: BodyFamily<3> = BodyFamily {
    id: "parallel_bodies",
    title: "Parallel bodies",
    description: "integer multiples, 1 to 1000, of 20 integer directions with coordinates in -50 ..= 50",
    is_random: true,
    generate: parallel,
};

/// Nearly parallel generators in eight directions.
pub const NOISY_DIRECTIONS_BODIES: BodyFamily<3> = BodyFamily {
    id: "noisy_directions_bodies",
    title: "Eight noisy directions",
    description: "unit vectors in eight directions, each coordinate with normal noise of standard deviation 1e-9",
    is_random: true,
    generate: noisy_directions,
};

const PARALLEL_DIRECTIONS: usize = 20;
const LARGEST_COORDINATE: usize = 50;
const LARGEST_MULTIPLE: usize = 1000;
const NOISY_DIRECTIONS: usize = 8;
const NOISE: f64 = 1e-9;

fn sorted(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    let upwards = |v: [f64; 3]| if v[2] < 0.0 { v.map(|c| -c) } else { v };
    let mut generators: Vec<[f64; 3]> = (0..n).map(|_| upwards(normal_vector(&mut source))).collect();
    generators.sort_by(|a, b| (a[0] * b[2]).total_cmp(&(b[0] * a[2])));
    generators
}

fn parallel(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    let coordinate =
        |source: &mut RandomSource| source.below(2 * LARGEST_COORDINATE + 1) as f64 - LARGEST_COORDINATE as f64;
    let directions: Vec<[f64; 3]> =
        (0..PARALLEL_DIRECTIONS).map(|_| std::array::from_fn(|_| coordinate(&mut source))).collect();
    (0..n)
        .map(|_| {
            let direction = directions[source.below(PARALLEL_DIRECTIONS)];
            let multiple = 1.0 + source.below(LARGEST_MULTIPLE) as f64;
            direction.map(|c| multiple * c)
        })
        .collect()
}

fn noisy_directions(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    let directions: Vec<[f64; 3]> = (0..NOISY_DIRECTIONS).map(|_| unit_vector(&mut source)).collect();
    (0..n)
        .map(|_| {
            let direction = directions[source.below(NOISY_DIRECTIONS)];
            let noise: [f64; 3] = normal_vector(&mut source);
            std::array::from_fn(|i| direction[i] + NOISE * noise[i])
        })
        .collect()
}
