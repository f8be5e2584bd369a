//! The pass over generators that sums up, with their signs, those whose sign is fixed in a cone, and reports the
//! others.
//!
//! The pass reads every generator, so it is the kernel's largest cost. It takes eight generators at a time in vectors
//! of doubles and never branches on a sign: lanes that cross the cell keep the sum that they have, and a bit of a word
//! for each generator tells in the end which these are.

use std::ops::Range;
use std::slice;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::direction_cone::DirectionCone;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::lanes::bit_places::{WORD, places_of};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{LANES, Octet, in_order_of_rows, splat, total, totals, turned};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::euclidean_norm;
use crate::numeric::reused::Reused;
use crate::numeric::tolerance::{CONE_ROUNDING, PRODUCT_UNDERFLOW, SQUARABLE_SIZES, THIRTY_ROUNDINGS, UNIT};

/// Generators of a block, at whose end the sum joins the total without a rounding error. A term goes through one
/// addition for each eight generators of its block.
const BLOCK: usize = 256;

/// The words of a pass that has at most this many are kept on the stack: a list takes longer than the pass itself.
const STANDING_WORDS: usize = 8;

/// (a + b)² ≤ (1 + SQUARE_SPLIT) a² + (1 + 1 / SQUARE_SPLIT) b².
const SQUARE_SPLIT: f64 = 1.0 / 1024.0;

/// Mostly at most so many generators cross a cell that is narrow.
pub(crate) const USUAL_CROSSING: usize = 64;

/// Places of generators.
pub(crate) type Places = Reused<u32>;

/// Σ sign · v over generators whose sign is fixed throughout a cell, in doubles.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct FixedSum {
    pub(crate) sum: [f64; 3],
    /// At least Σ |v| over all generators read.
    pub(crate) magnitude: f64,
    /// A bound for the error of each coordinate of the sum.
    pub(crate) error: f64,
    /// The number of generators that were read, or of sums of generators in their place.
    pub(crate) read: usize,
}

impl FixedSum {
    pub(crate) fn bounded(&self) -> BoundedVector {
        self.sum.map(|value| Bounded { value, error: self.error })
    }

    /// Both sums together.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let sum = [0, 1, 2].map(|k| self.sum[k] + other.sum[k]);
        let magnitude = self.magnitude + other.magnitude;
        let error = self.error + other.error + 4.0 * UNIT * magnitude;
        Self { sum, magnitude, error, read: self.read + other.read }
    }
}

impl DirectionCone {
    /// [`split`](Self::split) of the generators of some ranges alone, in their order; a range may begin and end
    /// anywhere where a block of eight does.
    pub(crate) fn split_ranges(
        &self,
        generators: Rows<'_>,
        ranges: &[Range<usize>],
        crossing: &mut Places,
    ) -> FixedSum {
        match self.axes {
            None => WideCone::<0>::new(self, [], 1.0).split(generators, ranges, crossing),
            Some(axes) => WideCone::<2>::new(self, axes, 1.0 + 1.0 / SQUARE_SPLIT).split(generators, ranges, crossing),
        }
    }

    /// Sums up, by one pass, the generators that are certainly orthogonal to no direction of the cell, and adds the
    /// places of the others to a list, in their order.
    ///
    /// The sign of v · u is that of v · center throughout the cell if |v · center| exceeds the sum of |v| ball and of
    /// √((v · axes_0)² + (v · axes_1)²). Each product with v is off by at most 3 u |v| times the length of the other
    /// factor and an underflow, which a wider ball covers.
    pub(crate) fn split(&self, generators: Rows<'_>, crossing: &mut Places) -> FixedSum {
        self.split_ranges(generators, slice::from_ref(&(0..generators.len())), crossing)
    }
}

/// A cell of `AXES` axes, widened by what rounding may take off the products with it.
struct WideCone<const AXES: usize> {
    center: [f64; 3],
    axes: [[f64; 3]; AXES],
    /// The square of the ball.
    square: f64,
}

impl<const AXES: usize> WideCone<AXES> {
    fn new(cell: &DirectionCone, axes: [[f64; 3]; AXES], factor: f64) -> Self {
        let size = euclidean_norm(&cell.center) + axes.iter().map(euclidean_norm).sum::<f64>() + cell.ball;
        let ball = (cell.ball + CONE_ROUNDING * size) * THIRTY_ROUNDINGS;
        let wider = (1.0 + SQUARE_SPLIT).sqrt() * THIRTY_ROUNDINGS;
        Self {
            center: cell.center,
            axes: axes.map(|axis| axis.map(|c| c * wider)),
            square: ball * ball * factor * THIRTY_ROUNDINGS,
        }
    }

    fn split(&self, generators: Rows<'_>, ranges: &[Range<usize>], crossing: &mut Places) -> FixedSum {
        // places are listed after the pass: a list that may grow within it would cost the sums their registers
        let count = ranges.iter().map(|range| range.len().div_ceil(WORD)).sum();
        if count <= STANDING_WORDS {
            return self.split_in(generators, ranges, &mut [0; STANDING_WORDS], crossing);
        }
        let mut words = Reused::with_capacity(count);
        words.resize(count, 0);
        self.split_in(generators, ranges, &mut words, crossing)
    }

    /// [`split`](Self::split), with room for a word for each [`WORD`] of a range.
    fn split_in(
        &self,
        generators: Rows<'_>,
        ranges: &[Range<usize>],
        words: &mut [u64],
        crossing: &mut Places,
    ) -> FixedSum {
        let fixed = dispatch!(level(), simd => split_at(simd, self, generators, ranges, words));
        let (mut words, mut room) = (words.iter(), [0; WORD]);
        for range in ranges {
            for (start, &word) in range.clone().step_by(WORD).zip(&mut words) {
                crossing.extend_from_slice(places_of(word, start as u32, &mut room));
            }
        }
        fixed
    }
}

/// Sums of the lanes, over a block and in all.
struct Sums<S: Simd> {
    /// Σ sign · v over the block.
    block: Octet<S>,
    /// Σ |v|² over the block.
    squares: f64x8<S>,
    /// The sum over the blocks before, and what rounding it left behind.
    total: Octet<S>,
    rest: Octet<S>,
    /// An upper bound of Σ |v| over the blocks before.
    magnitude: f64x8<S>,
}

impl<S: Simd> Sums<S> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        let zero = f64x8::splat(simd, 0.0);
        Self { block: [zero; 3], squares: zero, total: [zero; 3], rest: [zero; 3], magnitude: zero }
    }

    /// Adds those of eight vectors that certainly miss the cell, with the signs of their products with the centre, and
    /// returns a bit for each of these.
    #[inline(always)]
    fn read<const AXES: usize>(&mut self, simd: S, cone: &Splat<S, AXES>, v: &Octet<S>) -> u64 {
        let value = product(v, &cone.center);
        let squares = product(v, v);
        self.squares += squares;
        let mut reach = squares * cone.square + PRODUCT_UNDERFLOW;
        for axis in &cone.axes {
            let along = product(v, axis);
            reach += along * along;
        }
        // neither a product of zero, whatever its sign, nor NaN misses anything: such a vector is reported
        let misses = (value * value).simd_gt(reach);
        for (sum, c) in self.block.iter_mut().zip(v) {
            *sum = misses.select(*sum + turned(simd, *c, value), *sum);
        }
        misses.to_bitmask()
    }

    /// Moves the sum of a block to the total.
    #[inline(always)]
    fn end_block(&mut self, simd: S) {
        let zero = f64x8::splat(simd, 0.0);
        for k in 0..3 {
            let (a, b) = (self.total[k], self.block[k]);
            let sum = a + b;
            let b_in_sum = sum - a;
            self.rest[k] += (a - (sum - b_in_sum)) + (b - b_in_sum);
            (self.total[k], self.block[k]) = (sum, zero);
        }
        // by the inequality of Cauchy and Schwarz in each lane
        self.magnitude += (self.squares * (BLOCK / LANES) as f64).sqrt();
        self.squares = zero;
    }
}

/// The cone in all lanes.
struct Splat<S: Simd, const AXES: usize> {
    center: Octet<S>,
    axes: [Octet<S>; AXES],
    square: f64x8<S>,
}

#[inline(always)]
fn split_at<S: Simd, const AXES: usize>(
    simd: S,
    cone: &WideCone<AXES>,
    generators: Rows<'_>,
    ranges: &[Range<usize>],
    words: &mut [u64],
) -> FixedSum {
    let center = splat(simd, &cone.center);
    let mut axes = [center; AXES];
    for (own, axis) in axes.iter_mut().zip(&cone.axes) {
        *own = splat(simd, axis);
    }
    let wide = Splat { center, axes, square: f64x8::splat(simd, cone.square) };
    let mut sums = Sums::new(simd);
    let mut words = words.iter_mut();
    let (mut count, mut blocks) = (0, 0);
    for range in ranges {
        for block in generators.part(range.clone()).chunks(BLOCK) {
            for word in block.chunks(WORD) {
                let octets = word.octets();
                let mut misses = 0;
                for k in 0..octets.len() {
                    misses |= sums.read(simd, &wide, &octets.load(simd, k)) << (LANES * k);
                }
                if let Some(crosses) = words.next() {
                    *crosses = !in_order_of_rows(misses) & (u64::MAX >> (WORD - word.len()));
                }
            }
            sums.end_block(simd);
            blocks += 1;
        }
        count += range.len();
    }
    // three coordinates written out, as a closure may lose the instructions that this function is compiled for
    let sum = totals(&[sums.total[0] + sums.rest[0], sums.total[1] + sums.rest[1], sums.total[2] + sums.rest[2]]);
    fixed(sum, total(sums.magnitude), count, blocks)
}

/// The sum with a bound of its error.
fn fixed(sum: [f64; 3], magnitude: f64, count: usize, blocks: usize) -> FixedSum {
    // lengths whose squares underflow
    let magnitude = magnitude + count as f64 * SQUARABLE_SIZES.start;
    // a term goes through one addition for each eight generators of its block; ten more join lanes and totals
    let additions = (count.min(BLOCK).div_ceil(LANES) + 10) as f64;
    let blocks = blocks as f64;
    let slack = 1.0 + (blocks + BLOCK as f64) * 4.0 * UNIT;
    FixedSum { sum, magnitude: magnitude * slack, error: UNIT * (additions * magnitude) * slack, read: count }
}
