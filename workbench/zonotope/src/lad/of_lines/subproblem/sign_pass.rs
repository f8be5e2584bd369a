//! One pass over the lines: on which side of each a point or a cell certainly lies.
//!
//! The pass takes eight lines at a time and has no branch that depends on a sign, since a processor guesses half of
//! such branches wrong: every line contributes its normal with the sign of its value, masked out where the value does
//! not exceed its error bound.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_lines::input::rounded_lines::{BLOCK, Block, LineError, RoundedLines};
use crate::numeric::lanes::bit_places::{WORD, places_of};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, total, turned};
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// The signed sum of normals that a pass yields beside the signs.
#[derive(Debug, Default)]
pub(crate) struct SidesSum {
    /// The rounded sum Σ sign · normal over the lines whose side is certain.
    pub(crate) sum: [f64; 2],
    /// A bound on the error of each coordinate of the sum.
    pub(crate) sum_error: f64,
}

/// A point or a cell, as a pass sees it: what a line with coefficients x, y and offset b must exceed in magnitude there
/// for its side to be certain.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reading {
    /// The point, or the centre of the cell: the value of a line there is its sign.
    pub(crate) point: [f64; 2],
    /// The bound is |across · (x, y)| + per_x |x| + per_y |y| + per_offset |b| + floor.
    pub(crate) across: [f64; 2],
    pub(crate) per_x: f64,
    pub(crate) per_y: f64,
    pub(crate) per_offset: f64,
    pub(crate) floor: f64,
}

/// Writes the sign 1 or −1 of each line whose value exceeds its bound in magnitude, and for every other line the sign
/// that `uncertain` returns, given the line, its coefficients x, y and offset, and the bounds on their errors.
///
/// `reading` is made from the bounds on the errors of the lines in a block.
pub(crate) fn read_sides(
    lines: &RoundedLines,
    signs: &mut Vec<i8>,
    reading: impl Fn(LineError) -> Reading,
    mut uncertain: impl FnMut(usize, [f64; 3], LineError) -> i8,
) -> SidesSum {
    let n = lines.len();
    signs.clear();
    signs.reserve(n);
    let mut total = SidesSum::default();
    let mut magnitude = 0.0;
    let mut room = [0; WORD];
    lines.each_block(|start, block| {
        let reading = reading(block.error);
        let read = dispatch!(level(), simd => read_block(simd, &block, &reading, signs));
        total.sum[0] += read.sum[0];
        total.sum[1] += read.sum[1];
        magnitude += read.magnitude;
        for (word, bits) in read.uncertain.into_iter().enumerate().filter(|(_, bits)| *bits != 0) {
            for position in places_of(bits, (word * WORD) as u32, &mut room).iter().map(|&place| place as usize) {
                signs[start + position] = uncertain(start + position, block.row(position), block.error);
            }
        }
    });
    total.sum_error = UNIT * (BLOCK + n / BLOCK + 8) as f64 * magnitude + UNDERFLOW;
    total
}

/// The yield of a pass over a block.
struct ReadBlock {
    /// Σ sign · normal over the lines whose side is certain.
    sum: [f64; 2],
    /// Σ |normal|.
    magnitude: f64,
    /// A bit for each line whose side is not certain.
    uncertain: [u64; BLOCK / WORD],
}

/// Sums of eight lines side by side.
///
/// A block adds at most BLOCK terms one after the other, and blocks join the total one by one: hence the error bound of
/// the sum.
struct Sums<S: Simd> {
    x: f64x8<S>,
    y: f64x8<S>,
    magnitude: f64x8<S>,
}

/// A reading in all lanes.
struct Wide<S: Simd> {
    point: [f64x8<S>; 2],
    across: [f64x8<S>; 2],
    per_x: f64x8<S>,
    per_y: f64x8<S>,
    per_offset: f64x8<S>,
    floor: f64x8<S>,
    zero: f64x8<S>,
}

#[inline(always)]
fn read_block<S: Simd>(simd: S, block: &Block, reading: &Reading, signs: &mut Vec<i8>) -> ReadBlock {
    let wide = Wide {
        point: [f64x8::splat(simd, reading.point[0]), f64x8::splat(simd, reading.point[1])],
        across: [f64x8::splat(simd, reading.across[0]), f64x8::splat(simd, reading.across[1])],
        per_x: f64x8::splat(simd, reading.per_x),
        per_y: f64x8::splat(simd, reading.per_y),
        per_offset: f64x8::splat(simd, reading.per_offset),
        floor: f64x8::splat(simd, reading.floor),
        zero: f64x8::splat(simd, 0.0),
    };
    let mut sums = Sums { x: wide.zero, y: wide.zero, magnitude: wide.zero };
    let mut uncertain = [0; BLOCK / WORD];
    let (xs, last_x) = block.normal_x.as_chunks::<LANES>();
    let (ys, last_y) = block.normal_y.as_chunks::<LANES>();
    let (offsets, last_offset) = block.offset.as_chunks::<LANES>();
    let mut octet_signs = [[0; LANES]; BLOCK / LANES];
    for (k, ((x, y), b)) in xs.iter().zip(ys).zip(offsets).enumerate() {
        let [plus, certain] = sums.read(simd, &wide, [x, y, b]);
        octet_signs[k % (BLOCK / LANES)] = signs_of(plus, certain);
        uncertain[k / LANES] |= (!certain & 0xff) << (LANES * (k % LANES));
    }
    let whole = xs.len();
    if !last_x.is_empty() {
        let last = [padded(last_x, 0.0), padded(last_y, 0.0), padded(last_offset, 1.0)];
        let [plus, certain] = sums.read(simd, &wide, last.each_ref());
        octet_signs[whole % (BLOCK / LANES)] = signs_of(plus, certain);
        let present = (1 << last_x.len()) - 1;
        uncertain[whole / LANES] |= (!certain & present) << (LANES * (whole % LANES));
    }
    signs.extend_from_slice(&octet_signs.as_flattened()[..block.len()]);
    ReadBlock { sum: [total(sums.x), total(sums.y)], magnitude: total(sums.magnitude), uncertain }
}

/// The last lines of a block, filled up with others.
#[inline(always)]
fn padded(values: &[f64], fill: f64) -> [f64; LANES] {
    let mut all = [fill; LANES];
    all[..values.len()].copy_from_slice(values);
    all
}

impl<S: Simd> Sums<S> {
    /// Reads eight lines, and returns a bit for each whose value is not negative, and for each whose side is certain.
    #[inline(always)]
    fn read(&mut self, simd: S, wide: &Wide<S>, [x, y, b]: [&[f64; LANES]; 3]) -> [u64; 2] {
        let (x, y, b) = (f64x8::from_slice(simd, x), f64x8::from_slice(simd, y), f64x8::from_slice(simd, b));
        let value = x * wide.point[0] + y * wide.point[1] + b;
        let (size_x, size_y) = (x.abs(), y.abs());
        let reach = (x * wide.across[0] + y * wide.across[1]).abs();
        let bound = reach + size_x * wide.per_x + size_y * wide.per_y + b.abs() * wide.per_offset + wide.floor;
        let is_certain = value.abs().simd_gt(bound);
        self.x += is_certain.select(turned(simd, x, value), wide.zero);
        self.y += is_certain.select(turned(simd, y, value), wide.zero);
        self.magnitude += size_x + size_y;
        [value.simd_ge(wide.zero).to_bitmask(), is_certain.to_bitmask()]
    }
}

/// The signs of eight lines, given a bit for each that is positive and for each that is not 0.
#[inline(always)]
fn signs_of(plus: u64, certain: u64) -> [i8; LANES] {
    let positive = SPREAD_BITS[(plus & certain & 0xff) as usize];
    let negative = SPREAD_BITS[(!plus & certain & 0xff) as usize];
    // a byte of all ones is −1
    (positive | (negative * 0xff)).to_le_bytes().map(|byte| byte as i8)
}

/// The eight bits of an index, each in a byte of its own.
const SPREAD_BITS: [u64; 256] = {
    let mut spread = [0; 256];
    let mut bits = 0;
    while bits < 256 {
        let mut place = 0;
        while place < 8 {
            spread[bits] |= ((bits as u64 >> place) & 1) << (8 * place);
            place += 1;
        }
        bits += 1;
    }
    spread
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_become_signs() {
        assert_eq!(signs_of(0b0000_1011, 0b1000_0111), [1, 1, -1, 0, 0, 0, 0, -1]);
        assert_eq!((signs_of(0xff, 0xff), signs_of(0, 0xff), signs_of(0xff, 0)), ([1; 8], [-1; 8], [0; 8]));
    }
}
