//! The pass over generators that sums up, with their signs, those whose sign is fixed in a cone, and reports the
//! others.
//!
//! The pass reads every generator, so it is the kernel's largest cost. It takes two generators at a time in vectors of
//! doubles, never branches on a sign, and subtracts in the end what crossing generators added to the sum: a branch
//! for each generator would cost more than these few subtractions.

use wide::f64x2;

use super::direction_cone::DirectionCone;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::linear::euclidean_norm;
use crate::numeric::tolerance::{CONE_ROUNDING, PRODUCT_UNDERFLOW, SQUARABLE_SIZES, THIRTY_ROUNDINGS, UNIT};

/// Generators of a block: which of them cross the cell, and their signs, are gathered in one word, and the sum of a
/// block joins the total at its end.
const BLOCK: usize = 64;

/// (a + b)² ≤ (1 + SQUARE_SPLIT) a² + (1 + 1 / SQUARE_SPLIT) b².
const SQUARE_SPLIT: f64 = 1.0 / 1024.0;

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
    /// Sums up, by one pass, the generators that are certainly orthogonal to no direction of the cell, and reports
    /// the others.
    ///
    /// The sign of v · u is that of v · center throughout the cell if |v · center| exceeds the sum of |v| ball and of
    /// √((v · axes_0)² + (v · axes_1)²). Each product with v is off by at most 3 u |v| times the length of the other
    /// factor and an underflow, which a wider ball covers.
    pub(crate) fn split(&self, generators: &[[f64; 3]], report: impl FnMut(usize)) -> FixedSum {
        match self.axes {
            None => split(&WideCone::<0>::new(self, [], 1.0), generators, report),
            Some(axes) => split(&WideCone::<2>::new(self, axes, 1.0 + 1.0 / SQUARE_SPLIT), generators, report),
        }
    }
}

/// A vector in the order in which the coordinates of two vectors lie in memory: x y, z x, y z.
type Twice = [f64x2; 3];

fn twice([x, y, z]: [f64; 3]) -> Twice {
    [[x, y], [z, x], [y, z]].map(f64x2::new)
}

/// Either of two vectors times the same vector.
#[inline(always)]
fn products(pair: &Twice, other: &Twice) -> f64x2 {
    let [first, middle, last] = [pair[0] * other[0], pair[1] * other[1], pair[2] * other[2]];
    let [ends, others] = f64x2::transpose([first, last]);
    ends + others + middle
}

/// A cell of `AXES` axes in the order of memory, with the square of its ball.
struct WideCone<const AXES: usize> {
    center: Twice,
    axes: [Twice; AXES],
    square: f64x2,
}

impl<const AXES: usize> WideCone<AXES> {
    fn new(cell: &DirectionCone, axes: [[f64; 3]; AXES], factor: f64) -> Self {
        let size = euclidean_norm(&cell.center) + axes.iter().map(euclidean_norm).sum::<f64>() + cell.ball;
        let ball = (cell.ball + CONE_ROUNDING * size) * THIRTY_ROUNDINGS;
        let wider = (1.0 + SQUARE_SPLIT).sqrt() * THIRTY_ROUNDINGS;
        Self {
            center: twice(cell.center),
            axes: axes.map(|axis| twice(axis.map(|c| c * wider))),
            square: f64x2::splat(ball * ball * factor * THIRTY_ROUNDINGS),
        }
    }
}

/// Sums in the order of memory.
#[derive(Default)]
struct Sums {
    sum: Twice,
    /// Σ |v|².
    squares: f64x2,
}

impl Sums {
    /// Adds two vectors with the signs of their values. The first result has a bit for each vector that certainly
    /// misses the cell, the second one for each whose value is negative.
    #[inline(always)]
    fn read<const AXES: usize>(&mut self, cell: &WideCone<AXES>, pair: &Twice) -> [u64; 2] {
        let values = products(pair, &cell.center);
        let squares = products(pair, pair);
        self.squares += squares;
        let mut reach = squares * cell.square + f64x2::splat(PRODUCT_UNDERFLOW);
        for axis in &cell.axes {
            let value = products(pair, axis);
            reach += value * value;
        }
        let signs = values & f64x2::splat(-0.0);
        let [first, second] = f64x2::transpose([signs, signs]);
        self.sum[0] += pair[0] ^ first;
        self.sum[1] += pair[1] ^ signs;
        self.sum[2] += pair[2] ^ second;
        // a NaN misses nothing, so the vector is reported
        let misses = (values * values).simd_gt(reach).to_bitmask();
        [u64::from(misses), u64::from(values.to_bitmask())]
    }

    /// The sum, and an upper bound of the sum of the lengths.
    fn total(&self, count: usize) -> ([f64; 3], f64) {
        let [[x, y], [z, other_x], [other_y, other_z]] = self.sum.map(f64x2::to_array);
        let size = (self.squares.reduce_add() * count as f64).sqrt() + count as f64 * SQUARABLE_SIZES.start;
        ([x + other_x, y + other_y, z + other_z], size)
    }
}

fn split<const AXES: usize>(cell: &WideCone<AXES>, generators: &[[f64; 3]], mut report: impl FnMut(usize)) -> FixedSum {
    // the total of the sums of blocks, and the sum of what rounding that total leaves behind
    let (mut total, mut rest) = ([0.0; 3], [0.0; 3]);
    let (mut magnitude, mut error) = (0.0, 0.0);
    for (number, block) in generators.chunks(BLOCK).enumerate() {
        let mut sums = Sums::default();
        let mut taken = [0.0; 3];
        // the bits of a pair go in at the top and move down as others follow: no shift depends on the place
        let (mut misses, mut signs) = (0, 0);
        let (pairs, last) = block.as_chunks::<2>();
        for pair in pairs {
            let [own, minus] = sums.read(cell, &wide(*pair));
            misses = misses >> 2 | own << (BLOCK - 2);
            signs = signs >> 2 | minus << (BLOCK - 2);
        }
        let place = 2 * pairs.len();
        [misses, signs] = [misses, signs].map(|bits: u64| bits.checked_shr((BLOCK - place) as u32).unwrap_or(0));
        if let [last] = last {
            let [own, minus] = sums.read(cell, &wide([*last, [0.0; 3]]));
            misses |= (own & 1) << place;
            signs |= (minus & 1) << place;
        }
        let mut crosses = !misses & (u64::MAX >> (BLOCK - block.len()));
        let crossing = crosses.count_ones();
        while crosses != 0 {
            let place = crosses.trailing_zeros() as usize;
            crosses &= crosses - 1;
            let sign = (signs >> place) << 63;
            for (taken, c) in taken.iter_mut().zip(block[place]) {
                *taken += f64::from_bits(c.to_bits() ^ sign);
            }
            report(number * BLOCK + place);
        }
        let (sum, size) = sums.total(block.len());
        for k in 0..3 {
            let (sum, left) = exact_sum(total[k], sum[k] - taken[k]);
            total[k] = sum;
            rest[k] += left;
        }
        magnitude += size;
        // a term goes through one addition for each pair of its block, one that joins the lanes and one that
        // subtracts what crossing generators added; those generators, which at most double the terms, go through one
        // for each of them
        let additions = (BLOCK / 2 + 2) as f64 + 2.0 * f64::from(crossing);
        error += size * additions;
    }
    let sum = [0, 1, 2].map(|k| total[k] + rest[k]);
    let blocks = generators.len().div_ceil(BLOCK) as f64;
    let slack = 1.0 + (blocks + BLOCK as f64) * 4.0 * UNIT;
    // the sum of what the blocks leave behind has an error below one more rounding of the whole, and adding it has
    // another
    FixedSum { sum, magnitude: magnitude * slack, error: UNIT * (error + 6.0 * magnitude) * slack }
}

/// Two vectors in the order of memory.
#[inline(always)]
fn wide([[a, b, c], [d, e, f]]: [[f64; 3]; 2]) -> Twice {
    [[a, b], [c, d], [e, f]].map(f64x2::new)
}
