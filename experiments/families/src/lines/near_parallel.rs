//! Lines whose slopes agree to 1e-12.

use super::family::{LineFamily, LineRow};
use crate::source::RandomSource;

/// Slopes lie in this interval around zero.
const SLOPE: f64 = 1e-12;

/// Lines whose slopes agree to 1e-12.
pub const NEAR_PARALLEL_LINES: LineFamily = LineFamily {
    id: "near_parallel_lines",
    title: "Nearly parallel lines",
    description: "lines y = s x + t with |s| <= 1e-12 and t standard normal",
    generate: rows,
};

fn rows(n: usize, seed: u64) -> Vec<LineRow> {
    let mut source = RandomSource::new(seed);
    (0..n).map(|_| ([SLOPE * source.signed_unit(), -1.0], source.normal_pair()[0])).collect()
}
