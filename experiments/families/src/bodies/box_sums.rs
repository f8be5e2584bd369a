//! Sums of randomly turned boxes: for six generators the question of two boxes, the classical one of collision
//! detection.

use super::family::BodyFamily;
use super::random::unit_vector;
use crate::source::RandomSource;

/// Sums of randomly turned boxes.
pub const BOX_SUMS: BodyFamily<3> = BodyFamily {
    id: "box_sums",
    title: "Sums of boxes",
    description: "generators in threes, orthogonal up to rounding, of lengths uniform in [1/2, 2): boxes turned at \
        random",
    is_random: true,
    generate,
};

fn generate(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    let mut generators: Vec<[f64; 3]> = (0..n.div_ceil(3)).flat_map(|_| turned_box(&mut source)).collect();
    generators.truncate(n);
    generators
}

fn turned_box(source: &mut RandomSource) -> [[f64; 3]; 3] {
    let first = unit_vector(source);
    let second = loop {
        let [x, y, z] = cross(first, unit_vector(source));
        let length = (x * x + y * y + z * z).sqrt();
        if length > 0.1 {
            break [x / length, y / length, z / length];
        }
    };
    [first, second, cross(first, second)].map(|axis| {
        let half_length = 0.5 + 1.5 * source.unit();
        axis.map(|c| half_length * c)
    })
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
