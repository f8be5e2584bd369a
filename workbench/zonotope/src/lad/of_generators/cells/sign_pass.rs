//! The pass over generators that sums up, with their signs, those whose sign is fixed in a cone, and reports the
//! others.
//!
//! The pass reads every generator, so it is the kernel's largest cost. It takes eight generators at a time in vectors
//! of doubles, never branches on a sign, and subtracts in the end what crossing generators added to the sum: a branch
//! for each generator would cost more than these few subtractions.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};
use smallvec::SmallVec;

use super::direction_cone::DirectionCone;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{LANES, Octet, Octets, in_order_of_rows, splat, total, totals, turned};
use crate::numeric::linear::euclidean_norm;
use crate::numeric::tolerance::{CONE_ROUNDING, PRODUCT_UNDERFLOW, SQUARABLE_SIZES, THIRTY_ROUNDINGS, UNIT};

/// Generators of a block, at whose end the sum joins the total without a rounding error. A term goes through one
/// addition for each eight generators of its block.
const BLOCK: usize = 256;

/// Generators whose bits fill a word: which of them cross the cell, and their signs.
const WORD: usize = 64;

/// (a + b)² ≤ (1 + SQUARE_SPLIT) a² + (1 + 1 / SQUARE_SPLIT) b².
const SQUARE_SPLIT: f64 = 1.0 / 1024.0;

/// Places of generators; a few take no memory beside that of the list itself.
pub(crate) type Places = SmallVec<[u32; 16]>;

/// Σ sign · v over generators whose sign is fixed throughout a cell, in doubles.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct FixedSum {
    pub(crate) sum: [f64; 3],
    /// At least Σ |v| over all generators read.
    pub(crate) magnitude: f64,
    /// A bound for the error of each coordinate of the sum.
    pub(crate) error: f64,
}

impl FixedSum {
    pub(crate) fn bounded(&self) -> BoundedVector {
        self.sum.map(|value| Bounded { value, error: self.error })
    }

    /// Both sums together.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let sum = [0, 1, 2].map(|k| self.sum[k] + other.sum[k]);
        let magnitude = self.magnitude + other.magnitude;
        Self { sum, magnitude, error: self.error + other.error + 4.0 * UNIT * magnitude }
    }
}

impl DirectionCone {
    /// Sums up, by one pass, the generators that are certainly orthogonal to no direction of the cell, and adds the
    /// places of the others to a list, in their order.
    ///
    /// The sign of v · u is that of v · center throughout the cell if |v · center| exceeds the sum of |v| ball and of
    /// √((v · axes_0)² + (v · axes_1)²). Each product with v is off by at most 3 u |v| times the length of the other
    /// factor and an underflow, which a wider ball covers.
    pub(crate) fn split(&self, generators: &[[f64; 3]], crossing: &mut Places) -> FixedSum {
        match self.axes {
            None => WideCone::<0>::new(self, [], 1.0).split(generators, crossing),
            Some(axes) => WideCone::<2>::new(self, axes, 1.0 + 1.0 / SQUARE_SPLIT).split(generators, crossing),
        }
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

    fn split(&self, generators: &[[f64; 3]], crossing: &mut Places) -> FixedSum {
        dispatch!(level(), simd => split_at(simd, self, generators, crossing))
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

    /// Adds eight vectors with the signs of their products with the centre. The first result has a bit for each vector
    /// that certainly misses the cell, the second one for each whose product is negative.
    #[inline(always)]
    fn read<const AXES: usize>(&mut self, simd: S, cone: &Splat<S, AXES>, v: &Octet<S>) -> [u64; 2] {
        // a negative zero, which would be subtracted but does not compare as negative, becomes a positive one
        let value = product(v, &cone.center) + 0.0;
        let squares = product(v, v);
        self.squares += squares;
        let mut reach = squares * cone.square + PRODUCT_UNDERFLOW;
        for axis in &cone.axes {
            let along = product(v, axis);
            reach += along * along;
        }
        for (sum, c) in self.block.iter_mut().zip(v) {
            *sum += turned(simd, *c, value);
        }
        // a NaN misses nothing, so the vector is reported
        [(value * value).simd_gt(reach).to_bitmask(), value.simd_lt(0.0).to_bitmask()]
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
    generators: &[[f64; 3]],
    crossing: &mut Places,
) -> FixedSum {
    let center = splat(simd, &cone.center);
    let mut axes = [center; AXES];
    for (own, axis) in axes.iter_mut().zip(&cone.axes) {
        *own = splat(simd, axis);
    }
    let wide = Splat { center, axes, square: f64x8::splat(simd, cone.square) };
    let mut sums = Sums::new(simd);
    let mut taken = Taken::default();
    for (number, block) in generators.chunks(BLOCK).enumerate() {
        for (place, word) in block.chunks(WORD).enumerate() {
            let octets = Octets::new(word);
            let (mut misses, mut signs) = (0, 0);
            for k in 0..octets.len() {
                let [own, minus] = sums.read(simd, &wide, &octets.load(simd, k));
                misses |= own << (LANES * k);
                signs |= minus << (LANES * k);
            }
            let crosses = !in_order_of_rows(misses) & (u64::MAX >> (WORD - word.len()));
            if crosses != 0 {
                taken.read(word, crosses, in_order_of_rows(signs), number * BLOCK + place * WORD, crossing);
            }
        }
        sums.end_block(simd);
        taken.end_block();
    }
    // three coordinates written out, as a closure may lose the instructions that this function is compiled for
    let sum = totals(&[sums.total[0] + sums.rest[0], sums.total[1] + sums.rest[1], sums.total[2] + sums.rest[2]]);
    taken.fixed(sum, total(sums.magnitude), generators.len())
}

/// What crossing generators added to the sum, which is taken out again.
#[derive(Default)]
struct Taken {
    block: [f64; 3],
    total: [f64; 3],
    rest: [f64; 3],
    /// How many generators of the block cross the cell, and the most of a block.
    count: usize,
    most: usize,
}

impl Taken {
    /// Reads the generators of a word whose bits are set, with their signs, and reports their places.
    #[inline]
    fn read(&mut self, word: &[[f64; 3]], mut crosses: u64, signs: u64, first: usize, crossing: &mut Places) {
        self.count += crosses.count_ones() as usize;
        while crosses != 0 {
            let place = crosses.trailing_zeros() as usize;
            crosses &= crosses - 1;
            let sign = (signs >> place) << 63;
            for (sum, c) in self.block.iter_mut().zip(word[place]) {
                *sum += f64::from_bits(c.to_bits() ^ sign);
            }
            crossing.push((first + place) as u32);
        }
    }

    fn end_block(&mut self) {
        if self.count == 0 {
            return;
        }
        for k in 0..3 {
            let (sum, left) = exact_sum(self.total[k], self.block[k]);
            self.total[k] = sum;
            self.rest[k] += left;
        }
        self.most = self.most.max(self.count);
        (self.block, self.count) = ([0.0; 3], 0);
    }

    /// The sum of the others.
    fn fixed(&self, sum: [f64; 3], magnitude: f64, count: usize) -> FixedSum {
        let sum = [0, 1, 2].map(|k| (sum[k] - self.total[k]) - self.rest[k]);
        // lengths whose squares underflow
        let magnitude = magnitude + count as f64 * SQUARABLE_SIZES.start;
        // a term goes through one addition for each eight generators of its block; crossing generators, which at most
        // double the terms, go through one for each of them in their block; ten more join lanes and totals
        let additions = (count.min(BLOCK).div_ceil(LANES) + 10 + 2 * self.most) as f64;
        let blocks = count.div_ceil(BLOCK) as f64;
        let slack = 1.0 + (blocks + BLOCK as f64) * 4.0 * UNIT;
        FixedSum { sum, magnitude: magnitude * slack, error: UNIT * (additions * magnitude) * slack }
    }
}
