//! The vertices of a regular polygon on the unit circle.

use super::family::{Family, HullSize};
use std::f64::consts::TAU;

/// The vertices of the regular n-gon, in counter-clockwise order.
pub const REGULAR_POLYGON: Family = Family {
    id: "regular_polygon",
    title: "Regular polygon",
    description: "vertices of the regular n-gon on the unit circle; exactly centrally symmetric for even n; the seed \
        is not used",
    hull_size: HullSize::NearlyAll,
    is_random: false,
    generate: points,
};

fn points(n: usize, _seed: u64) -> Vec<[f64; 2]> {
    let vertex = |k: usize| {
        let (sin, cos) = libm::sincos(TAU * (k as f64 / n as f64));
        [cos, sin]
    };
    if n.is_multiple_of(2) {
        let half: Vec<_> = (0..n / 2).map(vertex).collect();
        let opposite = half.iter().map(|&[x, y]| [-x, -y]);
        half.iter().copied().chain(opposite).collect()
    } else {
        (0..n).map(vertex).collect()
    }
}
