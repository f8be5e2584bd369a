//! Lines through one common point, exactly.

use super::family::{LineFamily, LineRow};
use crate::source::RandomSource;

/// The common point.
const APEX: [f64; 2] = [3.0, -5.0];
/// Coordinates of the normals are half-integers below this power of two, so that the offset is exact.
const NORMAL_BITS: u32 = 40;

/// Lines through one common point.
pub const CONCURRENT_LINES: LineFamily = LineFamily {
    id: "concurrent_lines",
    title: "Concurrent lines",
    description: "random half-integer normals; every line passes through the point (3, -5) exactly",
    generate: rows,
};

fn rows(n: usize, seed: u64) -> Vec<LineRow> {
    let mut source = RandomSource::new(seed);
    let mut coordinate = || (source.bits() >> (63 - NORMAL_BITS)) as f64 - (1_u64 << NORMAL_BITS) as f64 + 0.5;
    (0..n)
        .map(|_| {
            let a = [coordinate(), coordinate()];
            (a, -(a[0] * APEX[0] + a[1] * APEX[1]))
        })
        .collect()
}
