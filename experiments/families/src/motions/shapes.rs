//! Shapes of which the scenes are made.

use std::f64::consts::PI;

use super::family::BodyRow;
use crate::bodies::unit_vector;
use crate::source::RandomSource;

/// A box along the coordinate axes, by its half sides.
pub(super) fn upright_box(center: [f64; 3], [x, y, z]: [f64; 3]) -> BodyRow {
    BodyRow { center, generators: vec![[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]] }
}

/// A box with these half sides in a random position.
pub(super) fn turned_box(source: &mut RandomSource, center: [f64; 3], halves: [f64; 3]) -> BodyRow {
    let axes = random_frame(source);
    BodyRow { center, generators: [0, 1, 2].map(|k| axes[k].map(|c| halves[k] * c)).to_vec() }
}

/// A prism about the z axis over a regular polygon of twice so many sides, by the radius of its generators' polygon and
/// half its height.
pub(super) fn prism(center: [f64; 3], sides: usize, radius: f64, half_height: f64) -> BodyRow {
    let length = radius * libm::sin(PI / (2.0 * sides as f64));
    let side = |k: usize| {
        let (sine, cosine) = libm::sincos(PI * k as f64 / sides as f64);
        [length * cosine, length * sine, 0.0]
    };
    BodyRow { center, generators: (0..sides).map(side).chain([[0.0, 0.0, half_height]]).collect() }
}

/// A number from a range.
pub(super) fn between(source: &mut RandomSource, low: f64, high: f64) -> f64 {
    low + (high - low) * source.unit()
}

/// A vertical axis that leans a little, of any length.
pub(super) fn leaning_axis(source: &mut RandomSource) -> [f64; 3] {
    [0.1 * source.signed_unit(), 0.1 * source.signed_unit(), 1.0]
}

/// Three orthonormal vectors, up to rounding.
fn random_frame(source: &mut RandomSource) -> [[f64; 3]; 3] {
    let first = unit_vector(source);
    loop {
        let other = unit_vector(source);
        let across = cross(first, other);
        let length = across.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length > 0.1 {
            let second = across.map(|c| c / length);
            return [first, second, cross(first, second)];
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
