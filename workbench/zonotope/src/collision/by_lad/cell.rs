//! A cone of directions, and which generators are orthogonal to none of them.

use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::UNIT;
use crate::numeric::vector::{self, ExactVector};

/// Covers the underflow of a dot product of doubles.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);

/// Generators read side by side.
const LANES: usize = 4;

/// Generators read before their sums join the total.
const BLOCK: usize = 256;

/// All positive multiples of center + s sides_0 + t sides_1, |s| ≤ 1, |t| ≤ 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub(super) center: [f64; 3],
    pub(super) sides: [[f64; 3]; 2],
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
    /// A dot product of doubles is off by at most 3 u |v|_1 max |u_k| and an underflow, so the sign of v · center is that throughout the
    /// cell if |v · center| exceeds |v · sides_0| + |v · sides_1| by the bounds of the three.
    pub(super) fn split(&self, generators: &[[f64; 3]], mut report: impl FnMut(usize)) -> FixedSum {
        let largest = |u: &[f64; 3]| u.iter().fold(0.0f64, |m, c| m.max(c.abs()));
        let margin = 8.0 * UNIT * (largest(&self.center) + largest(&self.sides[0]) + largest(&self.sides[1]));
        let mut total = FixedSum::default();
        let mut crossing = [0u32; BLOCK + LANES];
        for (number, block) in generators.chunks(BLOCK).enumerate() {
            let mut lanes = Lanes::default();
            let mut count = 0;
            let (rows, rest) = block.as_chunks::<LANES>();
            let mut read = |start: usize, vectors: &[[f64; 3]; LANES]| {
                let fixed = lanes.read(self, margin, vectors);
                for (lane, fixed) in fixed.into_iter().enumerate() {
                    crossing[count] = (start + lane) as u32;
                    count += usize::from(fixed == 0);
                }
            };
            for (row, vectors) in rows.iter().enumerate() {
                read(row * LANES, vectors);
            }
            if !rest.is_empty() {
                let mut vectors = [[0.0; 3]; LANES];
                vectors[..rest.len()].copy_from_slice(rest);
                read(rows.len() * LANES, &vectors);
            }
            let own = crossing[..count].iter().map(|&i| i as usize).filter(|&i| i < block.len());
            own.for_each(|i| report(number * BLOCK + i));
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

    /// Whether a direction is certainly in the cell.
    pub(super) fn contains(&self, u: &BoundedVector) -> bool {
        let [center, first, second] = [self.center, self.sides[0], self.sides[1]].map(bounded::exact);
        let determinant = bounded::dot(&center, &bounded::cross(&first, &second));
        let Some(sign) = determinant.sign() else { return false };
        let oriented = |value: Bounded| if sign < 0 { value.negated() } else { value };
        let height = oriented(bounded::dot(u, &bounded::cross(&first, &second)));
        let across = bounded::cross(u, &center);
        height.is_positive()
            && bounded::dot(&across, &second).is_within(height)
            && bounded::dot(&across, &first).is_within(height)
    }

    /// Whether a direction is in the cell.
    pub(super) fn contains_exactly(&self, u: &ExactVector) -> bool {
        let [center, first, second] = [self.center, self.sides[0], self.sides[1]].map(vector::exact);
        let normal = vector::cross(&first, &second);
        let sign = vector::dot(&center, &normal).sign();
        let height = vector::dot(u, &normal);
        let across = vector::cross(u, &center);
        let reaches = |side: &ExactVector| vector::dot(&across, side).abs() <= height.clone().abs();
        sign.is_ne() && height.sign() == sign && reaches(&first) && reaches(&second) && height != Dyadic::zero()
    }
}

#[derive(Default)]
struct Lanes {
    sums: [[f64; LANES]; 3],
    magnitude: [f64; LANES],
}

impl Lanes {
    /// Adds vectors side by side; returns 0 for those that may cross the cell.
    #[inline(always)]
    fn read(&mut self, cell: &Cell, margin: f64, vectors: &[[f64; 3]; LANES]) -> [u64; LANES] {
        const SIGN: u64 = 1 << 63;
        let (mut x, mut y, mut z) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            [x[lane], y[lane], z[lane]] = vectors[lane];
        }
        let (mut negative, mut fixed) = ([0u64; LANES], [0u64; LANES]);
        for lane in 0..LANES {
            let along = |u: &[f64; 3]| x[lane] * u[0] + y[lane] * u[1] + z[lane] * u[2];
            let size = x[lane].abs() + y[lane].abs() + z[lane].abs();
            let value = along(&cell.center);
            let reach = along(&cell.sides[0]).abs() + along(&cell.sides[1]).abs() + (margin * size + TINY);
            negative[lane] = value.to_bits() & SIGN;
            fixed[lane] = if value.abs() > reach { u64::MAX } else { 0 };
            self.magnitude[lane] += size;
        }
        for lane in 0..LANES {
            let signed = |c: f64| f64::from_bits((c.to_bits() ^ negative[lane]) & fixed[lane]);
            self.sums[0][lane] += signed(x[lane]);
            self.sums[1][lane] += signed(y[lane]);
            self.sums[2][lane] += signed(z[lane]);
        }
        fixed
    }

    fn join(&self, total: &mut FixedSum) {
        for (sum, lanes) in total.sum.iter_mut().zip(&self.sums) {
            *sum += lanes.iter().sum::<f64>();
        }
        total.magnitude += self.magnitude.iter().sum::<f64>();
    }
}
