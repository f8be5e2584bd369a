//! One pass over the lines: on which side of each a point or a cell certainly lies.
//!
//! The pass has no branch that depends on a sign, since a processor guesses half of such branches wrong: every line
//! contributes its normal with the sign of its value, masked out where the value does not exceed its error bound.

use fearless_simd::{Simd, dispatch};

use crate::lad::of_lines::input::rounded_lines::{BLOCK, Block, LineError, RoundedLines};
use crate::numeric::lanes::level::level;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// The signed sum of normals that a pass yields beside the signs.
#[derive(Debug, Default)]
pub(crate) struct SidesSum {
    /// The rounded sum Σ sign · normal over the lines whose side is certain.
    pub(crate) sum: [f64; 2],
    /// A bound on the error of each coordinate of the sum.
    pub(crate) sum_error: f64,
}

/// Writes the sign 1 or −1 of each line whose value exceeds its bound in magnitude, and for every other line the sign
/// that `uncertain` returns, given the line, its coefficients x, y and offset, and the bounds on their errors.
///
/// `reader` makes, from the bounds on the errors of the lines in a block, the function from a line's coefficients to
/// its value and the bound on the value.
pub(crate) fn read_sides<R: Fn(f64, f64, f64) -> (f64, f64)>(
    lines: &RoundedLines,
    signs: &mut Vec<i8>,
    reader: impl Fn(LineError) -> R,
    mut uncertain: impl FnMut(usize, [f64; 3], LineError) -> i8,
) -> SidesSum {
    let n = lines.len();
    signs.clear();
    signs.resize(n, 0);
    let mut total = SidesSum::default();
    let mut magnitude = 0.0;
    lines.each_block(|start, block| {
        let value_and_bound = reader(block.error);
        let mut zeros = Zeros { positions: [0; BLOCK + LANES], count: 0 };
        let signs = &mut signs[start..start + block.len()];
        let lanes = dispatch!(level(), simd => read_block(simd, &block, signs, &mut zeros, &value_and_bound));
        let sum: [f64; 2] = [lanes.x.iter().sum(), lanes.y.iter().sum()];
        total.sum[0] += sum[0];
        total.sum[1] += sum[1];
        magnitude += lanes.magnitude.iter().sum::<f64>();
        for position in zeros.positions[..zeros.count].iter().map(|&position| usize::from(position)) {
            signs[position] = uncertain(start + position, block.row(position), block.error);
        }
    });
    total.sum_error = UNIT * (BLOCK + n / BLOCK + 8) as f64 * magnitude + UNDERFLOW;
    total
}

/// Reads the lines of a block and collects the positions of those whose sign is zero. Compiled for each set of vector
/// instructions, with the same sums at each.
#[inline(always)]
fn read_block<S: Simd>(
    _simd: S,
    block: &Block,
    signs: &mut [i8],
    zeros: &mut Zeros,
    value_and_bound: &impl Fn(f64, f64, f64) -> (f64, f64),
) -> Lanes {
    let mut lanes = Lanes::default();
    let (sign_chunks, sign_rest) = signs.as_chunks_mut::<LANES>();
    let (x_chunks, x_rest) = block.normal_x.as_chunks::<LANES>();
    let (y_chunks, y_rest) = block.normal_y.as_chunks::<LANES>();
    let (offset_chunks, offset_rest) = block.offset.as_chunks::<LANES>();
    let chunks = x_chunks.iter().zip(y_chunks).zip(offset_chunks).zip(sign_chunks);
    for (chunk, (((x, y), b), signs)) in chunks.enumerate() {
        if lanes.read(x, y, b, signs, value_and_bound) {
            zeros.gather(signs, chunk * LANES);
        }
    }
    if !sign_rest.is_empty() {
        let mut rest = [0; LANES];
        let padded = |values: &[f64], fill| std::array::from_fn(|i| values.get(i).copied().unwrap_or(fill));
        lanes.read(&padded(x_rest, 0.0), &padded(y_rest, 0.0), &padded(offset_rest, 1.0), &mut rest, value_and_bound);
        sign_rest.copy_from_slice(&rest[..sign_rest.len()]);
        zeros.gather(sign_rest, block.len() - x_rest.len());
    }
    lanes
}

/// The positions of the zero signs in a block.
struct Zeros {
    /// The positions up to `count`; what follows is room to write to before it is known whether a sign is zero.
    positions: [u16; BLOCK + LANES],
    count: usize,
}

impl Zeros {
    /// Collects the positions of zeros among some signs, without a branch on a sign.
    #[inline(always)]
    fn gather(&mut self, signs: &[i8], start: usize) {
        for (position, sign) in (start..).zip(signs) {
            self.positions[self.count] = position as u16;
            self.count += usize::from(*sign == 0);
        }
    }
}

/// Number of lines that are read side by side.
///
/// A block adds at most BLOCK terms one after the other, and blocks join the total one by one: hence the error bound of
/// the sum.
const LANES: usize = 8;

#[derive(Default)]
struct Lanes {
    x: [f64; LANES],
    y: [f64; LANES],
    magnitude: [f64; LANES],
}

impl Lanes {
    /// Reads `LANES` lines side by side, and returns whether some value did not exceed its bound.
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
