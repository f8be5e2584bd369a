//! Lines in pairs that mirror each other in the x axis.

use super::family::{LineFamily, LineRow};
use crate::source::RandomSource;

/// Lines in pairs that mirror each other in the x axis.
pub const SYMMETRIC_LINES: LineFamily = LineFamily {
    id: "symmetric_lines",
    title: "Symmetric lines",
    description: "random lines in exact mirror pairs y = s x + t, y = -s x - t (and the x axis when n is odd)",
    generate: rows,
};

fn rows(n: usize, seed: u64) -> Vec<LineRow> {
    let mut source = RandomSource::new(seed);
    let mut rows: Vec<LineRow> = (0..n / 2)
        .flat_map(|_| {
            let [x, y] = source.unit_vector();
            let offset = source.normal_pair()[0];
            [([x, y], offset), ([x, -y], offset)]
        })
        .collect();
    rows.resize(n, ([0.0, 1.0], 0.0));
    rows
}
