//! Generators in common planes: exactly, nearly, and on a lattice where most facets have more than four sides.

use super::family::BodyFamily;
use super::random::normal_vector;
use crate::source::RandomSource;

/// All generators in the plane x = z.
pub const FLAT_BODIES: BodyFamily<3> = BodyFamily {
    id: "flat_bodies",
    title: "Flat bodies",
    description: "generators (a, b, a) with a and b standard normal: exactly in the plane x = z",
    is_random: true,
    generate: flat,
};

/// Nine in ten generators near a plane.
pub const NEAR_PLANE_BODIES: BodyFamily<3> = BodyFamily {
    id: "near_plane_bodies",
    title: "Near a plane",
    description: "standard normal generators, of nine in ten of them the distance from the plane x = z shrunk to a \
        millionth",
    is_random: true,
    generate: near_plane,
};

/// Small integer generators in space.
pub const LATTICE_BODIES: BodyFamily<3> = BodyFamily {
    id: "lattice_bodies",
    title: "Lattice bodies",
    description: "integer generators with coordinates in -8 ..= 8",
    is_random: true,
    generate: lattice,
};

/// Small integer generators in the plane.
pub const LATTICE_ZONOGONS: BodyFamily<2> = BodyFamily {
    id: "lattice_zonogons",
    title: "Lattice zonogons",
    description: "integer generators in the plane with coordinates in -8 ..= 8",
    is_random: true,
    generate: lattice,
};

/// Small integer generators in R^4.
pub const LATTICE_BODIES_4: BodyFamily<4> = BodyFamily {
    id: "lattice_bodies_4",
    title: "Lattice bodies in R^4",
    description: "integer generators in R^4 with coordinates in -8 ..= 8",
    is_random: true,
    generate: lattice,
};

/// By how much a generator near the plane leaves it, relative to its length.
const DISTANCE_FROM_PLANE: f64 = 1e-6;
/// The largest coordinate of a lattice generator, in absolute value.
const LARGEST_COORDINATE: usize = 8;

fn flat(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let [a, b] = source.normal_pair();
            [a, b, a]
        })
        .collect()
}

fn near_plane(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let [along, across, away]: [f64; 3] = normal_vector(&mut source);
            let away = if source.below(10) == 0 { away } else { DISTANCE_FROM_PLANE * away };
            [along + away, across, along - away]
        })
        .collect()
}

fn lattice<const D: usize>(n: usize, seed: u64) -> Vec<[f64; D]> {
    let mut source = RandomSource::new(seed);
    let mut coordinate = || source.below(2 * LARGEST_COORDINATE + 1) as f64 - LARGEST_COORDINATE as f64;
    (0..n)
        .map(|_| {
            loop {
                let generator = std::array::from_fn(|_| coordinate());
                if generator != [0.0; D] {
                    break generator;
                }
            }
        })
        .collect()
}
