//! Vectors of space kept as a pass wants them: eight in a block, one coordinate after the other, each where one load of
//! the widest vector fetches it.

use fearless_simd::{Simd, f64x8, prelude::*};

use super::octet::{LANES, Octet};

/// Eight vectors side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub(crate) struct Block([[f64; LANES]; 3]);

impl Block {
    /// The vectors of an octet.
    #[inline(always)]
    pub(crate) fn of<S: Simd>(octet: &Octet<S>) -> Self {
        let mut block = Self([[0.0; LANES]; 3]);
        for (column, lanes) in block.0.iter_mut().zip(octet) {
            lanes.store_slice(column);
        }
        block
    }

    /// The vectors of three columns.
    pub(crate) const fn of_columns(columns: [[f64; LANES]; 3]) -> Self {
        Self(columns)
    }

    #[inline(always)]
    pub(crate) fn load<S: Simd>(&self, simd: S) -> Octet<S> {
        let Self([x, y, z]) = self;
        [f64x8::from_slice(simd, x), f64x8::from_slice(simd, y), f64x8::from_slice(simd, z)]
    }

    /// The vector in a lane.
    #[inline(always)]
    pub(crate) fn vector(&self, lane: usize) -> [f64; 3] {
        let Self([x, y, z]) = self;
        [x[lane], y[lane], z[lane]]
    }
}

/// Vectors from which a pass loads eight at a time; what the last eight lack is zero.
pub(crate) trait Source {
    /// How many octets there are.
    fn count(&self) -> usize;

    /// The coordinates of the octet at a place.
    fn octet<S: Simd>(&self, simd: S, place: usize) -> Octet<S>;
}

impl Source for &[Block] {
    #[inline(always)]
    fn count(&self) -> usize {
        self.len()
    }

    #[inline(always)]
    fn octet<S: Simd>(&self, simd: S, place: usize) -> Octet<S> {
        self[place].load(simd)
    }
}
