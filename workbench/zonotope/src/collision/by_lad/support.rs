//! The support function with a bound on its error, in one pass.

use crate::numeric::bounded::Bounded;
use crate::numeric::tolerance::UNIT;

const LANES: usize = 8;
const BLOCK: usize = 512;

/// Covers the underflow of a dot product.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);

/// Σ |v · u|.
///
/// A dot product is off by at most 3 u |v|_1 max |u_k|; the sums are taken in blocks, so a term goes through few additions.
pub(super) fn support(generators: &[[f64; 3]], u: &[f64; 3]) -> Bounded {
    let (mut value, mut magnitude) = (0.0, 0.0);
    for block in generators.chunks(BLOCK) {
        let (mut values, mut sizes) = ([0.0; LANES], [0.0; LANES]);
        let (rows, rest) = block.as_chunks::<LANES>();
        for row in rows {
            read(row, u, &mut values, &mut sizes);
        }
        for v in rest {
            read(&[*v], u, &mut values, &mut sizes);
        }
        value += values.iter().sum::<f64>();
        magnitude += sizes.iter().sum::<f64>();
    }
    let additions = (BLOCK / LANES + 2 * LANES + generators.len() / BLOCK + 4) as f64;
    let largest = u.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let error = UNIT * (additions * value + 4.0 * magnitude * largest) * (1.0 + 4.0 * additions * UNIT);
    Bounded { value, error: error + generators.len() as f64 * TINY }
}

#[inline(always)]
fn read<const N: usize>(vectors: &[[f64; 3]; N], u: &[f64; 3], values: &mut [f64; LANES], sizes: &mut [f64; LANES]) {
    for lane in 0..N {
        let [x, y, z] = vectors[lane];
        values[lane] += (x * u[0] + y * u[1] + z * u[2]).abs();
        sizes[lane] += x.abs() + y.abs() + z.abs();
    }
}
