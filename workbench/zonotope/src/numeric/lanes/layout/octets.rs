//! Rows eight by eight: from blocks where the rows were laid out, else taken apart as they are read.

use fearless_simd::Simd;

use super::blocks::{Block, Source};
use super::octet::{LANES, Octet, taken_apart};

/// Rows in eights, the last of them filled up with zeros where they are not [taken apart](Self::whole_and_rest).
#[derive(Clone, Copy)]
pub(crate) struct Octets<'a> {
    whole: &'a [[f64; 3 * LANES]],
    rest: &'a [f64],
    /// The same rows in blocks, if somebody laid them out.
    blocks: &'a [Block],
}

impl<'a> Octets<'a> {
    #[inline(always)]
    pub(crate) fn new(rows: &'a [[f64; 3]], blocks: &'a [Block]) -> Self {
        let (whole, rest) = rows.as_flattened().as_chunks();
        Self { whole, rest, blocks }
    }

    /// The full octets alone, and the rows that are left, as one number after the other.
    #[inline(always)]
    pub(crate) fn whole_and_rest(&self) -> (Self, &'a [[f64; 3]]) {
        // a load looks for a block first: that of the rest must not be found
        let blocks = self.blocks.get(..self.whole.len()).unwrap_or_default();
        (Self { whole: self.whole, rest: &[], blocks }, self.rest.as_chunks().0)
    }

    /// How many octets there are.
    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.whole.len() + usize::from(!self.rest.is_empty())
    }

    /// The coordinates of eight rows.
    #[inline(always)]
    pub(crate) fn load<S: Simd>(&self, simd: S, place: usize) -> Octet<S> {
        if let Some(block) = self.blocks.get(place) {
            return block.load(simd);
        }
        if let Some(rows) = self.whole.get(place) {
            return taken_apart(simd, rows);
        }
        let mut rows = [0.0; 3 * LANES];
        for (own, c) in rows.iter_mut().zip(self.rest) {
            *own = *c;
        }
        taken_apart(simd, &rows)
    }
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

/// Rows in blocks, in the order of the lanes in which passes over rows take them.
#[inline(always)]
pub(crate) fn blocks_of<S: Simd>(simd: S, rows: &[[f64; 3]]) -> Vec<Block> {
    let octets = Octets::new(rows, &[]);
    let mut blocks = Vec::with_capacity(octets.len());
    for k in 0..octets.len() {
        blocks.push(Block::of(&octets.load(simd, k)));
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_rows_fill_up_an_octet() {
        let rows: Vec<[f64; 3]> = (0..11).map(|i| [f64::from(i); 3]).collect();
        let octets = Octets::new(&rows, &[]);
        assert_eq!((octets.len(), octets.whole.len()), (2, 1));
        assert_eq!(octets.rest, [8.0, 8.0, 8.0, 9.0, 9.0, 9.0, 10.0, 10.0, 10.0]);
    }
}
