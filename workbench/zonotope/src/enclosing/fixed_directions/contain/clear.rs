//! The quick proof that a point is inside: an error bound in doubles, for points clear of the boundary.
//!
//! If the ray to a point leaves the zonotope well beyond the point, there are coefficients δ_i well within [−1, 1]
//! with Σ δ_i c_i v_i near the point. What the sum misses of the point, rounding errors included, is bounded in the
//! coordinates of the basis. Where each bound fits between |δ_i| and 1, changes of the basis's coefficients make up for
//! the miss, so the point is inside.

use super::body::Body;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::zonotope::ray_exit::Exit;

/// A rounded inverse whose product with the matrix is farther from the identity than this proves nothing.
const LARGEST_INVERSE_ERROR: f64 = 1e-3;

impl<const D: usize> Body<'_, D> {
    /// Whether the residual of a point, given relative to the centre as `q`, certainly fits between the coefficients of
    /// the basis and ±1. `extents` bounds the sums of the generators' magnitudes along each axis, `inverse_error` is
    /// what [`basis_inverse_error`](Self::basis_inverse_error) returned.
    ///
    /// Let R be the rounded inverse and R B = I + E. The coordinates of a residual r are (I + E)⁻¹ R r, so each is at
    /// most its own |R r| plus 2 e Σ |R r|, e the largest entry of E: the rows mix, and a row of a nearly dependent
    /// basis may be far longer than another.
    pub(super) fn is_clear(&self, q: &[f64; D], exit: &Exit<D>, extents: &[f64; D], inverse_error: f64) -> bool {
        let rank = self.scaled.rank;
        let count = self.generators.len() as f64;
        let bound: [f64; D] = std::array::from_fn(|c| {
            (exit.sum[c] - q[c]).abs()
                + (count + 8.0) * UNIT * extents[c]
                + 8.0 * UNIT * q[c].abs()
                + (count + 8.0) * UNDERFLOW * (1.0 + self.coefficient_sum)
        });
        let reach = |i: usize| (0..rank).map(|c| self.basis_inverse[i][c].abs() * bound[c]).sum::<f64>();
        let mixed = 2.0 * inverse_error * (0..rank).map(reach).sum::<f64>();
        self.basis
            .iter()
            .enumerate()
            .all(|(i, &b)| 1.0625 * (reach(i) + mixed) <= self.coefficient(b) * (1.0 - exit.most) * (1.0 - 1e-6))
    }

    /// A bound for the entries of R B − I, where R is the rounded inverse of the matrix B of the basis; `None` where
    /// the inverse is not worth anything.
    pub(super) fn basis_inverse_error(&self) -> Option<f64> {
        let rank = self.scaled.rank;
        let mut largest = 0.0f64;
        for (i, row) in self.basis_inverse.iter().enumerate().take(rank) {
            for (k, &b) in self.basis.iter().enumerate() {
                let column = &self.scaled.directions[b].vector;
                let off = (dot(row, column) - f64::from(u8::from(i == k))).abs();
                let size: f64 = row.iter().zip(column).map(|(r, c)| (r * c).abs()).sum();
                let error = off + (2.0 * D as f64 + 4.0) * UNIT * (size + 1.0);
                // NaN is no bound
                largest = if error > largest || error.is_nan() { error } else { largest };
            }
        }
        (largest <= LARGEST_INVERSE_ERROR).then_some(largest)
    }
}
