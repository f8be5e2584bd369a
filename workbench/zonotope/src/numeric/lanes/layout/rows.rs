//! Vectors of space as a pass takes them: a list of rows, and where a body was prepared, blocks and sums beside it.

use std::ops::Range;

use super::blocks::Block;
use super::octet::{LANES, slot};
use super::octets::Octets;

/// Rows, with what was prepared for passes over them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rows<'a> {
    list: &'a [[f64; 3]],
    /// The same vectors in blocks; none where nobody laid them out.
    blocks: &'a [Block],
    /// Sums over all rows; none where nobody made them, or where these rows are a part of those.
    sums: Option<&'a BodySums>,
}

/// Blocks and sums of a list of rows, 24 bytes a row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LaidOut {
    pub(super) blocks: Vec<Block>,
    pub(super) sums: BodySums,
}

impl LaidOut {
    pub(crate) fn blocks(&self) -> &[Block] {
        &self.blocks
    }
}

/// Sums over the vectors of a body; |v| is the largest magnitude of a coordinate of v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BodySums {
    /// Σ v vᵀ: xx, xy, xz, yy, yz, zz.
    pub(super) squares: [f64; 6],
    /// Σ v vᵀ / |v|.
    pub(super) weighted_squares: [f64; 6],
    /// The largest |v|, and Σ |v|.
    pub(super) sizes: [f64; 2],
}

impl BodySums {
    /// At least Σ |v|_1, but for the roundings of a sum over the vectors.
    #[inline]
    pub(crate) fn magnitude(&self) -> f64 {
        3.0 * self.sizes[1]
    }
}

impl<'a> Rows<'a> {
    pub(crate) const NONE: Self = Self { list: &[], blocks: &[], sums: None };

    /// Rows as they come.
    #[inline(always)]
    pub(crate) const fn new(list: &'a [[f64; 3]]) -> Self {
        Self { list, blocks: &[], sums: None }
    }

    /// Rows with the blocks in which they were written down.
    #[inline(always)]
    pub(super) const fn with_blocks(list: &'a [[f64; 3]], blocks: &'a [Block]) -> Self {
        Self { list, blocks, sums: None }
    }

    /// The rows that were laid out.
    #[inline(always)]
    pub(crate) fn laid_out(list: &'a [[f64; 3]], laid_out: &'a LaidOut) -> Self {
        Self { list, blocks: &laid_out.blocks, sums: Some(&laid_out.sums) }
    }

    /// The rows one after the other.
    #[inline(always)]
    pub(crate) fn list(self) -> &'a [[f64; 3]] {
        self.list
    }

    /// The blocks, if the rows were laid out.
    #[inline(always)]
    pub(crate) fn blocks(self) -> Option<&'a [Block]> {
        (!self.blocks.is_empty()).then_some(self.blocks)
    }

    /// The sums over all rows, if somebody made them.
    #[inline(always)]
    pub(crate) fn sums(self) -> Option<&'a BodySums> {
        self.sums
    }

    #[inline(always)]
    pub(crate) fn len(self) -> usize {
        self.list.len()
    }

    #[inline(always)]
    pub(crate) fn is_empty(self) -> bool {
        self.list.is_empty()
    }

    /// One of the rows, from the blocks if there are any: a pass over these leaves them nearer at hand.
    #[inline(always)]
    pub(crate) fn row(self, index: usize) -> [f64; 3] {
        match self.blocks.get(index / LANES) {
            Some(block) => block.vector(slot(index) % LANES),
            None => self.list[index],
        }
    }

    /// Adds some of the rows to the end of a list, as [`row`](Self::row) gives them.
    pub(crate) fn copy_some(self, places: &[u32], list: &mut Vec<[f64; 3]>) {
        // which of both they come from is asked once
        if self.blocks.is_empty() {
            list.extend(places.iter().map(|&place| self.list[place as usize]));
        } else {
            let in_blocks = |place: usize| self.blocks[place / LANES].vector(slot(place) % LANES);
            list.extend(places.iter().map(|&place| in_blocks(place as usize)));
        }
    }

    /// Some of the rows, from a place on that begins a block.
    #[inline(always)]
    pub(crate) fn part(self, range: Range<usize>) -> Self {
        let blocks = match self.blocks {
            [] => &[],
            blocks => &blocks[range.start / LANES..range.end.div_ceil(LANES)],
        };
        Self { list: &self.list[range], blocks, sums: None }
    }

    /// The rows in parts of so many, whole blocks each; the last part may be shorter.
    #[inline(always)]
    pub(crate) fn chunks(self, size: usize) -> impl Iterator<Item = Self> {
        let starts = (0..self.len()).step_by(size);
        starts.map(
            #[inline(always)]
            move |start| self.part(start..self.len().min(start + size)),
        )
    }

    /// The rows eight by eight.
    #[inline(always)]
    pub(crate) fn octets(self) -> Octets<'a> {
        Octets::new(self.list, self.blocks)
    }
}

/// Rows in two runs.
pub(crate) type Runs<'a> = [Rows<'a>; 2];

/// How many rows there are.
#[inline(always)]
pub(crate) fn count_of([first, second]: Runs<'_>) -> usize {
    first.len() + second.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::level::levels;
    use fearless_simd::{Simd, dispatch};

    #[inline(always)]
    fn coordinates<S: Simd>(simd: S, rows: Rows<'_>) -> Vec<[[f64; LANES]; 3]> {
        let octets = rows.octets();
        (0..octets.len()).map(|k| octets.load(simd, k).map(|lanes| std::array::from_fn(|lane| lanes[lane]))).collect()
    }

    #[test]
    fn blocks_hold_what_passes_over_rows_load() {
        for n in 0..40 {
            let list: Vec<[f64; 3]> = (0..n).map(|i| [0.0, 0.1, 0.2].map(|c| f64::from(i) + c)).collect();
            let known = laid_out(&list);
            let (plain, prepared) = (Rows::new(&list), Rows::laid_out(&list, &known));
            assert_eq!((plain.blocks().is_some(), prepared.blocks().is_some()), (false, n > 0));
            assert!((0..list.len()).all(|i| plain.row(i) == list[i] && prepared.row(i) == list[i]));
            for level in levels() {
                let of = |rows| dispatch!(level, simd => coordinates(simd, rows));
                assert_eq!(of(plain), of(prepared));
                for (own, other) in plain.chunks(16).zip(prepared.chunks(16)) {
                    assert_eq!((own.list(), of(own)), (other.list(), of(other)));
                }
            }
        }
    }

    #[test]
    fn rows_are_found_in_many_blocks() {
        let list: Vec<[f64; 3]> = (0..200).map(|i| [0.0, 0.1, 0.2].map(|c| f64::from(i) + c)).collect();
        let known = laid_out(&list);
        let some = [199, 0, 8, 9, 77, 9];
        let expected: Vec<[f64; 3]> = some.iter().map(|&place| list[place as usize]).collect();
        for rows in [Rows::new(&list), Rows::laid_out(&list, &known)] {
            assert!((0..list.len()).all(|i| rows.row(i) == list[i]));
            let mut copied = vec![[7.0; 3]];
            rows.copy_some(&some, &mut copied);
            assert_eq!((copied[0], &copied[1..]), ([7.0; 3], &expected[..]));
        }
    }
}
