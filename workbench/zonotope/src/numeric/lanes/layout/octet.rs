//! Eight vectors of space side by side, one coordinate in each vector of lanes.
//!
//! Eight rows are twenty-four doubles in three vectors of lanes, and a coordinate comes every third double: lane l of
//! the first coordinate is in the vector l mod 3. So three blends and two rotations take rows apart, where an order of
//! the lanes that follows the rows would take a permutation across lanes for each blend. The vector of space at place i
//! is in the lane 3 i mod 8, and that of the lane l is at the place 3 l mod 8.

use fearless_simd::{Simd, f64x8, mask64x8, prelude::*, u64x8};

/// Logical lanes of a pass.
pub(crate) const LANES: usize = 8;

/// Three coordinates of eight vectors of space.
pub(crate) type Octet<S> = [f64x8<S>; 3];

/// The slot of a row in a list of octets, and the row of a slot: this map is its own inverse.
#[inline(always)]
pub(crate) const fn slot(row: usize) -> usize {
    (row & !(LANES - 1)) | ((3 * row) & (LANES - 1))
}

/// Bits of eight octets in the order of the lanes, a byte an octet, moved to the order of the rows.
#[inline(always)]
pub(crate) const fn in_order_of_rows(bits: u64) -> u64 {
    // 1 and 3 change places, and 5 and 7, and 2 and 6
    let near = (bits >> 2 ^ bits) & 0x2222_2222_2222_2222;
    let bits = bits ^ near ^ near << 2;
    let far = (bits >> 4 ^ bits) & 0x0404_0404_0404_0404;
    bits ^ far ^ far << 4
}

/// The coordinates of eight rows.
#[inline(always)]
pub(crate) fn taken_apart<S: Simd>(simd: S, rows: &[f64; 3 * LANES]) -> Octet<S> {
    let (thirds, _) = rows.as_chunks::<LANES>();
    // written out: a closure may lose the instructions that its function is compiled for
    let a = f64x8::from_slice(simd, &thirds[0]);
    let b = f64x8::from_slice(simd, &thirds[1]);
    let c = f64x8::from_slice(simd, &thirds[2]);
    let first = mask64x8::from_bitmask(simd, 0b0100_1001);
    let second = mask64x8::from_bitmask(simd, 0b1001_0010);
    let third = mask64x8::from_bitmask(simd, 0b0010_0100);
    let x = first.select(a, second.select(b, c));
    let y = second.select(a, third.select(b, c));
    let z = third.select(a, first.select(b, c));
    [x, y.slide::<1>(y), z.slide::<2>(z)]
}

/// Numbers in the order of the lanes in the order of the rows, or the other way round: the same moves do both.
///
/// The row r takes the number of the lane r + 2 (r mod 4): two rotations, each for the rows that need it.
#[inline(always)]
pub(crate) fn reordered<S: Simd>(simd: S, lanes: f64x8<S>) -> f64x8<S> {
    let by_two = mask64x8::from_bitmask(simd, 0b1010_1010).select(lanes.slide::<2>(lanes), lanes);
    mask64x8::from_bitmask(simd, 0b1100_1100).select(by_two.slide::<4>(by_two), by_two)
}

/// Writes the first numbers to fewer than eight places.
#[inline(always)]
pub(crate) fn store_first<S: Simd>(numbers: f64x8<S>, places: &mut [f64]) {
    let mut all = [0.0; LANES];
    numbers.store_slice(&mut all);
    places.copy_from_slice(&all[..places.len()]);
}

/// Each coordinate's sum over the lanes.
#[inline(always)]
pub(crate) fn totals<S: Simd>(v: &Octet<S>) -> [f64; 3] {
    [total(v[0]), total(v[1]), total(v[2])]
}

/// The largest number of the lanes, none of which is NaN.
#[inline(always)]
pub(crate) fn largest<S: Simd>(lanes: f64x8<S>) -> f64 {
    let (first, second) = lanes.split();
    let (first, second) = first.max(second).split();
    let two = first.max(second);
    two[0].max(two[1])
}

/// The same vector in all lanes.
#[inline(always)]
pub(crate) fn splat<S: Simd>(simd: S, u: &[f64; 3]) -> Octet<S> {
    [f64x8::splat(simd, u[0]), f64x8::splat(simd, u[1]), f64x8::splat(simd, u[2])]
}

/// A number with its sign turned in the lanes where another one has its sign bit set.
#[inline(always)]
pub(crate) fn turned<S: Simd>(simd: S, x: f64x8<S>, by: f64x8<S>) -> f64x8<S> {
    let sign = by.bitcast::<u64x8<S>>() & u64x8::splat(simd, 1 << 63);
    (x.bitcast::<u64x8<S>>() ^ sign).bitcast()
}

/// The sum over the lanes, in an order that is the same at every level.
#[inline(always)]
pub(crate) fn total<S: Simd>(lanes: f64x8<S>) -> f64 {
    let (first, second) = lanes.split();
    let (first, second) = (first + second).split();
    let sums = first + second;
    sums[0] + sums[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::level::levels;
    use fearless_simd::dispatch;

    #[inline(always)]
    fn coordinates<S: Simd>(simd: S, rows: &[f64; 24]) -> [[f64; 8]; 3] {
        let v = taken_apart(simd, rows);
        v.map(|lanes| std::array::from_fn(|k| lanes[k]))
    }

    #[test]
    fn rows_come_apart_at_every_level() {
        let rows: [f64; 24] = std::array::from_fn(|i| i as f64);
        for level in levels() {
            let found = dispatch!(level, simd => coordinates(simd, &rows));
            for (axis, lanes) in found.iter().enumerate() {
                for (lane, &c) in lanes.iter().enumerate() {
                    assert_eq!(c, (3 * slot(lane) + axis) as f64, "{level:?}");
                }
            }
        }
    }

    #[test]
    fn slots_and_bits_are_in_the_same_order() {
        for row in 0..64 {
            assert_eq!(slot(slot(row)), row);
            assert_eq!(in_order_of_rows(1 << slot(row)), 1 << row);
        }
    }

    #[inline(always)]
    fn in_places<S: Simd>(simd: S, lanes: &[f64; 8], places: &mut [f64]) {
        store_first(reordered(simd, f64x8::from_slice(simd, lanes)), places);
    }

    #[test]
    fn numbers_of_lanes_go_to_the_places_of_their_rows() {
        let lanes: [f64; 8] = std::array::from_fn(|lane| slot(lane) as f64);
        for level in levels() {
            for len in 1..=8 {
                let mut places = vec![0.0; len];
                dispatch!(level, simd => in_places(simd, &lanes, &mut places));
                let rows: Vec<f64> = (0..len).map(|row| row as f64).collect();
                assert_eq!(places, rows, "{level:?}");
            }
        }
    }
}
