//! Lines with a uniform direction and a normal offset.

use super::family::{LineFamily, LineRow};
use crate::source::RandomSource;

/// Lines with a uniform direction and a normal offset.
pub const RANDOM_LINES: LineFamily = LineFamily {
    id: "random_lines",
    title: "Random lines",
    description: "unit normal of uniform direction, signed distance from the origin standard normal",
    generate: rows,
};

fn rows(n: usize, seed: u64) -> Vec<LineRow> {
    let mut source = RandomSource::new(seed);
    (0..n).map(|_| (source.unit_vector(), source.normal_pair()[0])).collect()
}
