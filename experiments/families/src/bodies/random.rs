//! Generators with independent standard normal coordinates: directions uniform, lengths of one order.

use super::family::BodyFamily;
use crate::source::RandomSource;

/// Normal generators in space.
pub const RANDOM_BODIES: BodyFamily<3> = BodyFamily {
    id: "random_bodies",
    title: "Random bodies",
    description: "generators with independent standard normal coordinates",
    is_random: true,
    generate: normal_vectors,
};

/// Normal generators in the plane.
pub const RANDOM_ZONOGONS: BodyFamily<2> = BodyFamily {
    id: "random_zonogons",
    title: "Random zonogons",
    description: "generators in the plane with independent standard normal coordinates",
    is_random: true,
    generate: normal_vectors,
};

/// Normal generators in R^4.
pub const RANDOM_BODIES_4: BodyFamily<4> = BodyFamily {
    id: "random_bodies_4",
    title: "Random bodies in R^4",
    description: "generators in R^4 with independent standard normal coordinates",
    is_random: true,
    generate: normal_vectors,
};

/// Unit generators in space.
pub const NEAR_BALLS: BodyFamily<3> = BodyFamily {
    id: "near_balls",
    title: "Near balls",
    description: "generators of length 1 in uniform directions",
    is_random: true,
    generate: |n, seed| {
        let mut source = RandomSource::new(seed);
        (0..n).map(|_| unit_vector(&mut source)).collect()
    },
};

fn normal_vectors<const D: usize>(n: usize, seed: u64) -> Vec<[f64; D]> {
    let mut source = RandomSource::new(seed);
    (0..n).map(|_| normal_vector(&mut source)).collect()
}

/// A vector of independent standard normal coordinates.
pub(super) fn normal_vector<const D: usize>(source: &mut RandomSource) -> [f64; D] {
    let mut vector = [0.0; D];
    for pair in vector.chunks_mut(2) {
        let drawn = source.normal_pair();
        pair.copy_from_slice(&drawn[..pair.len()]);
    }
    vector
}

/// A uniformly random unit vector, up to rounding.
pub(crate) fn unit_vector(source: &mut RandomSource) -> [f64; 3] {
    loop {
        let [x, y, z]: [f64; 3] = normal_vector(source);
        let length = (x * x + y * y + z * z).sqrt();
        if length > 0.0 {
            return [x / length, y / length, z / length];
        }
    }
}
