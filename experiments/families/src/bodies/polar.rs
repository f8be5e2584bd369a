//! Polar zonohedra: generators on a cone at equal angles.

use super::family::BodyFamily;
use std::f64::consts::TAU;

/// Polar zonohedra.
pub const POLAR_BODIES: BodyFamily<3> = BodyFamily {
    id: "polar_bodies",
    title: "Polar zonohedra",
    description: "generators (cos a, sin a, 1/2) at n equal angles a; the seed is not used",
    is_random: false,
    generate,
};

fn generate(n: usize, _seed: u64) -> Vec<[f64; 3]> {
    (0..n)
        .map(|k| {
            let (sin, cos) = libm::sincos(TAU * (k as f64 / n as f64));
            [cos, sin, 0.5]
        })
        .collect()
}
