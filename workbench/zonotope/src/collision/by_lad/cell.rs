//! A cone of directions, and which generators are orthogonal to none of them.

use wide::f64x2;

use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::UNIT;
use crate::numeric::vector::{self, ExactVector};

/// Covers the underflow of a dot product of doubles.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);

/// Generators whose crossings are gathered in one word.
const WORD: usize = 64;

/// Generators read before their sums join the total.
const BLOCK: usize = 2 * WORD;

/// Reaches that differ by no more than this factor are taken for the largest one.
const ROUND: f64 = 4.0;

/// All positive multiples of the directions in a box: those that differ from the centre by at most `reach` in each coordinate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub(super) center: [f64; 3],
    pub(super) reach: [f64; 3],
}

/// Σ sign · v over generators whose sign is fixed throughout a cell, in doubles.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct FixedSum {
    pub(super) sum: [f64; 3],
    /// Σ |v|_1 over all generators read, rounded.
    pub(super) magnitude: f64,
    /// A bound for the error of each coordinate of the sum.
    pub(super) error: f64,
}

impl FixedSum {
    pub(super) fn bounded(&self) -> BoundedVector {
        self.sum.map(|value| Bounded { value, error: self.error })
    }

    /// Both sums together.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let sum = [0, 1, 2].map(|k| self.sum[k] + other.sum[k]);
        let magnitude = self.magnitude + other.magnitude;
        Self { sum, magnitude, error: self.error + other.error + 4.0 * UNIT * magnitude }
    }
}

impl Cell {
    /// One pass: sums up the generators that are certainly orthogonal to no direction of the cell, and reports the others.
    ///
    /// The sign of v · center is that throughout the cell if |v · center| exceeds Σ |v_k| reach_k. Both sums of three products of
    /// doubles are off by at most 3 u Σ |v_k| (|center_k| + reach_k) and an underflow, which a wider reach makes up for.
    pub(super) fn split(&self, generators: &[[f64; 3]], report: impl FnMut(usize)) -> FixedSum {
        let wider = [0, 1, 2].map(|k| self.reach[k] + 8.0 * UNIT * (self.center[k].abs() + self.reach[k]));
        let largest = wider.iter().fold(0.0f64, |m, r| m.max(*r));
        if wider.iter().all(|r| r * ROUND >= largest) {
            split::<true>(&WideCell::new(&self.center, &[largest; 3]), generators, report)
        } else {
            split::<false>(&WideCell::new(&self.center, &wider), generators, report)
        }
    }

    /// v · center; its sign is that throughout the cell for every generator that is not reported.
    #[inline(always)]
    pub(super) fn value(&self, [x, y, z]: &[f64; 3]) -> f64 {
        let u = &self.center;
        x * u[0] + y * u[1] + z * u[2]
    }

    /// The cell of the directions that are one direction but for rounding.
    pub(super) fn around(direction: &BoundedVector) -> Self {
        Self { center: direction.map(|c| c.value), reach: direction.map(|c| c.error) }
    }

    /// Whether a direction u is certainly in the cell, when scaled such that u · p is center · p.
    pub(super) fn contains(&self, u: &BoundedVector, p: &BoundedVector) -> bool {
        let center = bounded::exact(self.center);
        let (along, own) = (bounded::dot(u, p), bounded::dot(&center, p));
        let is_near = |k: usize| (u[k] * own - center[k] * along).is_within(along * Bounded::exact(self.reach[k]));
        along.is_positive() && own.is_positive() && (0..3).all(is_near)
    }

    /// Whether a direction u with u · p > 0 is in the cell, when scaled such that u · p is center · p.
    pub(super) fn contains_exactly(&self, u: &ExactVector, p: &ExactVector) -> bool {
        let (center, reach) = (vector::exact(self.center), vector::exact(self.reach));
        let (along, own) = (vector::dot(u, p), vector::dot(&center, p));
        let is_near = |k: usize| (&u[k] * &own - &center[k] * &along).abs() <= &along * &reach[k];
        along.sign().is_gt() && own.sign().is_gt() && (0..3).all(is_near)
    }
}

/// A cell in the order in which the coordinates of two vectors lie in memory: x y, z x, y z.
struct WideCell {
    center: [f64x2; 3],
    reach: [f64x2; 3],
}

impl WideCell {
    fn new(center: &[f64; 3], reach: &[f64; 3]) -> Self {
        let twice = |[x, y, z]: &[f64; 3]| [[*x, *y], [*z, *x], [*y, *z]].map(f64x2::new);
        Self { center: twice(center), reach: twice(reach) }
    }

    /// v · center in the lane of either vector.
    #[inline(always)]
    fn values(&self, pair: &[f64x2; 3]) -> f64x2 {
        across([0, 1, 2].map(|k| pair[k] * self.center[k]))
    }
}

/// The sum over the coordinates of either of two vectors.
#[inline(always)]
fn across([first, middle, last]: [f64x2; 3]) -> f64x2 {
    let [ends, others] = f64x2::transpose([first, last]);
    ends + others + middle
}

/// Sums in the order of memory.
#[derive(Default)]
struct Sums {
    sum: [f64x2; 3],
    magnitude: [f64x2; 3],
}

impl Sums {
    /// Adds two vectors with the signs of their values; a bit for each that may cross the cell. With one reach for all coordinates the first
    /// magnitude is that of both vectors.
    #[inline(always)]
    fn read<const ROUND: bool>(&mut self, cell: &WideCell, pair: &[f64x2; 3]) -> u32 {
        let values = cell.values(pair);
        let sizes = pair.map(f64x2::abs);
        let reach = if ROUND {
            let total = across(sizes);
            self.magnitude[0] += total;
            total * cell.reach[0]
        } else {
            for (sum, size) in self.magnitude.iter_mut().zip(sizes) {
                *sum += size;
            }
            across([0, 1, 2].map(|k| sizes[k] * cell.reach[k]))
        };
        let signs = values & f64x2::splat(-0.0);
        let [first, second] = f64x2::transpose([signs, signs]);
        for ((sum, c), sign) in self.sum.iter_mut().zip(pair).zip([first, signs, second]) {
            *sum += *c ^ sign;
        }
        // not less: NaN crosses
        !values.abs().simd_gt(reach + f64x2::splat(TINY)).to_bitmask() & 0b11
    }

    /// Takes a vector out that was added, in the lane where it was.
    fn take(&mut self, v: &[f64; 3], value: f64) {
        let sign = f64x2::splat(-f64::copysign(1.0, value));
        for (sum, c) in self.sum.iter_mut().zip([[v[0], v[1]], [v[2], 0.0]]) {
            *sum += sign * f64x2::new(c);
        }
    }

    fn vector(&self) -> [f64; 3] {
        let [[x, y], [z, other_x], [other_y, other_z]] = self.sum.map(f64x2::to_array);
        [x + other_x, y + other_y, z + other_z]
    }

    fn size(&self) -> f64 {
        self.magnitude.iter().map(|m| m.reduce_add()).sum()
    }
}

fn split<const ROUND: bool>(cell: &WideCell, generators: &[[f64; 3]], mut report: impl FnMut(usize)) -> FixedSum {
    // the sums of blocks, and what their rounding leaves behind
    let (mut total, mut rest) = ([0.0; 3], [0.0; 3]);
    let (mut magnitude, mut error) = (0.0, 0.0);
    for (number, block) in generators.chunks(BLOCK).enumerate() {
        let mut sums = Sums::default();
        let mut crossing = 0u32;
        for (word, part) in block.chunks(WORD).enumerate() {
            let mut bits = 0u64;
            let (pairs, last) = part.as_chunks::<2>();
            for (place, pair) in pairs.iter().enumerate() {
                bits |= u64::from(sums.read::<ROUND>(cell, &wide(*pair))) << (2 * place);
            }
            if let [last] = last {
                bits |= u64::from(sums.read::<ROUND>(cell, &wide([*last, [0.0; 3]])) & 1) << (2 * pairs.len());
            }
            crossing += bits.count_ones();
            while bits != 0 {
                let place = bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let v = &part[place];
                // in the lane where it was read: a sum in another order may have another sign
                let pair = if place.is_multiple_of(2) { [*v, [0.0; 3]] } else { [[0.0; 3], *v] };
                sums.take(v, cell.values(&wide(pair)).to_array()[place % 2]);
                report(number * BLOCK + word * WORD + place);
            }
        }
        for ((total, rest), sum) in total.iter_mut().zip(&mut rest).zip(sums.vector()) {
            let (sum, left) = exact_sum(*total, sum);
            *total = sum;
            *rest += left;
        }
        let size = sums.size();
        magnitude += size;
        // a term goes through an addition for each pair, for each that is taken out, which at most doubles the terms, and one for both lanes
        error += size * (f64::from(crossing) * 2.0 + if crossing == 0 { 1.0 } else { 2.0 } * (BLOCK / 2 + 1) as f64);
    }
    let sum = [0, 1, 2].map(|k| total[k] + rest[k]);
    let blocks = generators.len().div_ceil(BLOCK) as f64;
    let slack = 1.0 + (blocks + BLOCK as f64) * 4.0 * UNIT;
    // what the blocks leave behind is summed up with less than one more rounding of the whole, and added with another
    FixedSum { sum, magnitude: magnitude * slack, error: UNIT * (error + 4.0 * magnitude) * slack }
}

/// Two vectors in the order of memory.
#[inline(always)]
fn wide([[a, b, c], [d, e, f]]: [[f64; 3]; 2]) -> [f64x2; 3] {
    [[a, b], [c, d], [e, f]].map(f64x2::new)
}
