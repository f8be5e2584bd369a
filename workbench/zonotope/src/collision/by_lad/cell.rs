//! A cone of directions, and which generators are orthogonal to none of them.

use wide::f64x2;

use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::tolerance::UNIT;
use crate::numeric::vector::{self, ExactVector};

/// Covers the underflow of a dot product of doubles.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);

/// Generators read side by side.
const LANES: usize = 2;

/// Generators read before their sums join the total.
const BLOCK: usize = 256;

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
    pub(super) fn split(&self, generators: &[[f64; 3]], mut report: impl FnMut(usize)) -> FixedSum {
        let wider = [0, 1, 2].map(|k| self.reach[k] + 8.0 * UNIT * (self.center[k].abs() + self.reach[k]));
        let wide = WideCell { center: self.center.map(f64x2::splat), reach: wider.map(f64x2::splat) };
        let mut total = FixedSum::default();
        let mut crossing = [0u32; 2 * BLOCK];
        for (number, block) in generators.chunks(BLOCK).enumerate() {
            let mut lanes = Lanes::default();
            let mut count = 0;
            let (rows, rest) = block.as_chunks::<LANES>();
            for (row, &[first, second]) in rows.iter().enumerate() {
                // written always and counted if it crosses: no branch to be guessed wrong
                let missing = !lanes.read(&wide, first, second) as usize;
                for lane in 0..LANES {
                    crossing[count % crossing.len()] = (row * LANES + lane) as u32;
                    count += missing >> lane & 1;
                }
            }
            if let &[last] = rest
                && lanes.read(&wide, last, [0.0; 3]) & 1 == 0
            {
                crossing[count] = (rows.len() * LANES) as u32;
                count += 1;
            }
            crossing[..count].iter().for_each(|&i| report(number * BLOCK + i as usize));
            lanes.join(&mut total);
        }
        // a term goes through at most BLOCK / LANES + LANES additions in its block and one for each block
        let additions = (BLOCK / LANES + LANES + generators.len() / BLOCK + 4) as f64;
        total.magnitude *= 1.0 + additions * 2.0 * UNIT;
        total.error = UNIT * additions * total.magnitude;
        total
    }

    /// The sign of v · center, the sign throughout the cell of every generator that is not reported.
    #[inline]
    pub(super) fn sign(&self, [x, y, z]: &[f64; 3]) -> i8 {
        let u = &self.center;
        if x * u[0] + y * u[1] + z * u[2] < 0.0 { -1 } else { 1 }
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

/// Sums side by side.
#[derive(Default)]
struct Lanes {
    sum: [f64x2; 3],
    magnitude: f64x2,
}

impl Lanes {
    /// Adds two vectors; returns a bit for each that certainly misses the cell.
    #[inline(always)]
    fn read(&mut self, cell: &WideCell, first: [f64; 3], second: [f64; 3]) -> u32 {
        let v = [0, 1, 2].map(|k| f64x2::new([first[k], second[k]]));
        let [ax, ay, az] = v.map(f64x2::abs);
        let value = v[0] * cell.center[0] + v[1] * cell.center[1] + v[2] * cell.center[2];
        let reach = ax * cell.reach[0] + ay * cell.reach[1] + az * cell.reach[2] + f64x2::splat(TINY);
        let fixed = value.abs().simd_gt(reach);
        let negative = value & f64x2::splat(-0.0);
        for (sum, c) in self.sum.iter_mut().zip(v) {
            *sum += (c ^ negative) & fixed;
        }
        self.magnitude += ax + ay + az;
        fixed.to_bitmask()
    }

    fn join(&self, total: &mut FixedSum) {
        for (sum, lanes) in total.sum.iter_mut().zip(self.sum) {
            *sum += lanes.reduce_add();
        }
        total.magnitude += self.magnitude.reduce_add();
    }
}

/// A cell in each lane.
struct WideCell {
    center: [f64x2; 3],
    reach: [f64x2; 3],
}
