//! One pass over the lines that tells on which side of each a point or a cell lies, where floating point can.
//!
//! The pass has no branch that depends on a sign: every line contributes its normal with the sign of its value, masked out where the
//! value does not exceed its error bound.

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
        let chunks = x_chunks.iter().zip(y_chunks).zip(offset_chunks).zip(sign_chunks);
        for (chunk, (((x, y), b), signs)) in chunks.enumerate() {
            if lanes.read(x, y, b, signs, &value_and_bound) {
                report_zeros(signs, start + chunk * LANES, &mut uncertain);
            }
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
            report_zeros(sign_rest, start + x.len() - x_rest.len(), &mut uncertain);
        }
        let sum: [f64; 2] = [lanes.x.iter().sum(), lanes.y.iter().sum()];
        total.sum[0] += sum[0];
        total.sum[1] += sum[1];
        magnitude += lanes.magnitude.iter().sum::<f64>();
    }
    total.sum_error = UNIT * (BLOCK + n / BLOCK + 8) as f64 * magnitude + UNDERFLOW;
    total
}

fn report_zeros(signs: &[i8], start: usize, uncertain: &mut impl FnMut(usize)) {
    for (i, _) in signs.iter().enumerate().filter(|(_, sign)| **sign == 0) {
        uncertain(start + i);
    }
}

/// Lines read side by side. A block sums BLOCK terms at most one after the other, and blocks join the total one by one,
/// which gives the error bound of the sum.
const LANES: usize = 8;
const BLOCK: usize = 256;

#[derive(Default)]
struct Lanes {
    x: [f64; LANES],
    y: [f64; LANES],
    magnitude: [f64; LANES],
}

impl Lanes {
    /// Reads lines side by side; returns whether some value did not exceed its bound.
    #[inline(always)]
    fn read(
        &mut self,
        x: &[f64; LANES],
        y: &[f64; LANES],
        offset: &[f64; LANES],
        signs: &mut [i8; LANES],
        value_and_bound: impl Fn(f64, f64, f64) -> (f64, f64),
    ) -> bool {
        const SIGN: u64 = 1 << 63;
        let (mut negative, mut certain) = ([0; LANES], [0; LANES]);
        for lane in 0..LANES {
            let (value, bound) = value_and_bound(x[lane], y[lane], offset[lane]);
            negative[lane] = value.to_bits() & SIGN;
            certain[lane] = if value.abs() > bound { u64::MAX } else { 0 };
        }
        for lane in 0..LANES {
            self.x[lane] += f64::from_bits((x[lane].to_bits() ^ negative[lane]) & certain[lane]);
            self.y[lane] += f64::from_bits((y[lane].to_bits() ^ negative[lane]) & certain[lane]);
            self.magnitude[lane] += x[lane].abs() + y[lane].abs();
        }
        for lane in 0..LANES {
            signs[lane] = (1 - (negative[lane] >> 62) as i8) & certain[lane] as i8;
        }
        certain.iter().fold(u64::MAX, |all, lane| all & lane) == 0
    }
}
