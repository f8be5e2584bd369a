//! Vectors of space kept as a pass wants them: eight in a block, one coordinate after the other, each where one load of
//! the widest vector fetches it.

use fearless_simd::{Simd, f64x8, prelude::*};

use super::octet::{LANES, Octet, Octets};

/// Eight vectors side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub(crate) struct Block([[f64; LANES]; 3]);

/// Vectors from which a pass loads eight at a time; what the last eight lack is zero.
pub(crate) trait Source {
    /// How many octets there are.
    fn count(&self) -> usize;

    /// The coordinates of the octet at a place.
    fn octet<S: Simd>(&self, simd: S, place: usize) -> Octet<S>;
}

impl Source for Octets<'_> {
    #[inline(always)]
    fn count(&self) -> usize {
        self.len()
    }

    #[inline(always)]
    fn octet<S: Simd>(&self, simd: S, place: usize) -> Octet<S> {
        self.load(simd, place)
    }
}

impl Source for &[Block] {
    #[inline(always)]
    fn count(&self) -> usize {
        self.len()
    }

    #[inline(always)]
    fn octet<S: Simd>(&self, simd: S, place: usize) -> Octet<S> {
        let Block([x, y, z]) = &self[place];
        [f64x8::from_slice(simd, x), f64x8::from_slice(simd, y), f64x8::from_slice(simd, z)]
    }
}

/// Rows in blocks, in the order of the lanes in which passes over rows take them.
#[inline(always)]
pub(crate) fn blocks_of<S: Simd>(simd: S, rows: &[[f64; 3]]) -> Vec<Block> {
    let octets = Octets::new(rows);
    let mut blocks = Vec::with_capacity(octets.len());
    for k in 0..octets.len() {
        let v = octets.load(simd, k);
        let mut block = Block([[0.0; LANES]; 3]);
        for (column, lanes) in block.0.iter_mut().zip(v) {
            lanes.store_slice(column);
        }
        blocks.push(block);
    }
    blocks
}
