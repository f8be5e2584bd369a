//! Lines with small integer coefficients: 80 directions, and many lines through every vertex.

use super::family::{LineFamily, LineRow};
use crate::source::RandomSource;

/// Coefficients of the normal lie in -8 ..= 8.
const LARGEST_NORMAL: usize = 8;
/// Offsets lie in -64 ..= 64.
const LARGEST_OFFSET: usize = 64;

/// Lines with small integer coefficients.
pub const LATTICE_LINES: LineFamily = LineFamily {
    id: "lattice_lines",
    title: "Lattice lines",
    description: "integer normal with coordinates in -8 ..= 8, integer offset in -64 ..= 64",
    generate: rows,
};

fn rows(n: usize, seed: u64) -> Vec<LineRow> {
    let mut source = RandomSource::new(seed);
    let mut within = |largest: usize| source.below(2 * largest + 1) as f64 - largest as f64;
    (0..n)
        .map(|_| {
            let normal = loop {
                let normal = [within(LARGEST_NORMAL), within(LARGEST_NORMAL)];
                if normal != [0.0, 0.0] {
                    break normal;
                }
            };
            (normal, within(LARGEST_OFFSET))
        })
        .collect()
}
