//! One pass over the lines that tells on which side of each a point or a cell lies, where floating point can.
//!
//! The pass is free of branches: every line contributes its normal with the sign of its value, and only a block in which
//! some value does not exceed its error bound is read again line by line.

use super::problem::Columns;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// What a pass yields beside the signs.
#[derive(Debug, Default)]
pub(crate) struct SidesSum {
    /// Σ sign · normal over the lines whose side is certain.
    pub(crate) sum: [f64; 2],
    /// Bounds how far each coordinate of the sum may be off.
    pub(crate) sum_error: f64,
}

/// Writes 1 or −1 for each line whose value exceeds its bound in magnitude, else 0 and calls `uncertain` with the line.
///
/// `value_and_bound` is given the coefficients x, y and the offset of a line.
pub(crate) fn read_sides(
    columns: &Columns,
    signs: &mut Vec<i8>,
    value_and_bound: impl Fn(f64, f64, f64) -> (f64, f64),
    mut uncertain: impl FnMut(usize),
) -> SidesSum {
    let n = columns.len();
    signs.clear();
    signs.resize(n, 0);
    let mut total = SidesSum::default();
    let mut magnitude = 0.0;
    for (block, signs) in signs.chunks_mut(BLOCK).enumerate() {
        let start = block * BLOCK;
        let range = start..start + signs.len();
        let (x, y) = (&columns.normal_x[range.clone()], &columns.normal_y[range.clone()]);
        let offset = &columns.offset[range];
        let mut lanes = Lanes::default();
        let (sign_chunks, sign_rest) = signs.as_chunks_mut::<LANES>();
        let ((x_chunks, x_rest), (y_chunks, y_rest)) = (x.as_chunks::<LANES>(), y.as_chunks::<LANES>());
        let (offset_chunks, offset_rest) = offset.as_chunks::<LANES>();
        for (((x, y), b), signs) in x_chunks.iter().zip(y_chunks).zip(offset_chunks).zip(sign_chunks) {
            lanes.read(x, y, b, signs, &value_and_bound);
        }
        if !sign_rest.is_empty() {
            let mut rest = [0; LANES];
            let padded = |values: &[f64], fill| std::array::from_fn(|i| values.get(i).copied().unwrap_or(fill));
            lanes.read(
                &padded(x_rest, 0.0),
                &padded(y_rest, 0.0),
                &padded(offset_rest, 1.0),
                &mut rest,
                &value_and_bound,
            );
            sign_rest.copy_from_slice(&rest[..sign_rest.len()]);
        }
        let mut sum = [lanes.x.iter().sum(), lanes.y.iter().sum()];
        if !lanes.certain {
            sum = reread(x, y, offset, signs, &value_and_bound, |i| uncertain(start + i));
        }
        total.sum[0] += sum[0];
        total.sum[1] += sum[1];
        magnitude += lanes.magnitude.iter().sum::<f64>();
    }
    total.sum_error = UNIT * (BLOCK + n / BLOCK + 8) as f64 * magnitude + UNDERFLOW;
    total
}

/// The signs of a block line by line, with the sum over those that are certain.
fn reread(
    x: &[f64],
    y: &[f64],
    offset: &[f64],
    signs: &mut [i8],
    value_and_bound: impl Fn(f64, f64, f64) -> (f64, f64),
    mut uncertain: impl FnMut(usize),
) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (i, sign) in signs.iter_mut().enumerate() {
        let (value, bound) = value_and_bound(x[i], y[i], offset[i]);
        if value.abs() > bound {
            sum[0] += f64::from(*sign) * x[i];
            sum[1] += f64::from(*sign) * y[i];
        } else {
            *sign = 0;
            uncertain(i);
        }
    }
    sum
}

/// Lines read side by side. A block sums BLOCK terms at most one after the other, and blocks join the total one by one,
/// which gives the error bound of the sum.
const LANES: usize = 8;
const BLOCK: usize = 256;

struct Lanes {
    x: [f64; LANES],
    y: [f64; LANES],
    magnitude: [f64; LANES],
    certain: bool,
}

impl Default for Lanes {
    fn default() -> Self {
        Self { x: [0.0; LANES], y: [0.0; LANES], magnitude: [0.0; LANES], certain: true }
    }
}

impl Lanes {
    #[inline(always)]
    fn read(
        &mut self,
        x: &[f64; LANES],
        y: &[f64; LANES],
        offset: &[f64; LANES],
        signs: &mut [i8; LANES],
        value_and_bound: impl Fn(f64, f64, f64) -> (f64, f64),
    ) {
        const SIGN: u64 = 1 << 63;
        for lane in 0..LANES {
            let (value, bound) = value_and_bound(x[lane], y[lane], offset[lane]);
            let negative = value.to_bits() & SIGN;
            signs[lane] = 1 - 2 * (negative >> 63) as i8;
            self.x[lane] += f64::from_bits(x[lane].to_bits() ^ negative);
            self.y[lane] += f64::from_bits(y[lane].to_bits() ^ negative);
            self.magnitude[lane] += x[lane].abs() + y[lane].abs();
            self.certain &= value.abs() > bound;
        }
    }
}
