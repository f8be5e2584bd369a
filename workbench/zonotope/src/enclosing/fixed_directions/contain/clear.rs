//! The quick proof that a point is inside: an error bound in doubles, for points clear of the boundary.
//!
//! If the ray to a point leaves the zonotope well beyond the point, there are coefficients δ_i well within [−1, 1]
//! with Σ δ_i c_i v_i near the point. What the sum misses of the point, rounding errors included, is bounded in the
//! coordinates of the basis. Where each bound fits between |δ_i| and 1, changes of the basis's coefficients make up for
//! the miss, so the point is inside.

use super::body::Body;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::zonotope::ray_exit::{Exit, dot};

impl<const D: usize> Body<'_, D> {
    /// Whether the residual of a point, given relative to the centre as `q`, certainly fits between the coefficients of
    /// the basis and ±1. `extents` bounds the sums of the generators' magnitudes along each axis.
    pub(super) fn is_clear(&self, q: &[f64; D], exit: &Exit<D>, extents: &[f64; D]) -> bool {
        let rank = self.scaled.rank;
        let count = self.generators.len() as f64;
        let bound: [f64; D] = std::array::from_fn(|c| {
            (exit.sum[c] - q[c]).abs()
                + (count + 8.0) * UNIT * extents[c]
                + 8.0 * UNIT * q[c].abs()
                + (count + 8.0) * UNDERFLOW
        });
        self.basis.iter().enumerate().all(|(i, &b)| {
            let reach: f64 = (0..rank).map(|c| self.basis_inverse[i][c].abs() * bound[c]).sum();
            1.0625 * reach <= self.coefficient(b) * (1.0 - exit.most) * (1.0 - 1e-6)
        })
    }

    /// Whether the rounded inverse times the matrix of the basis is near the identity, so that
    /// [`is_clear`](Self::is_clear) may take it for the exact inverse.
    pub(super) fn basis_inverse_is_good(&self) -> bool {
        let rank = self.scaled.rank;
        (0..rank).all(|i| {
            let row = &self.basis_inverse[i];
            let off = |k: usize| {
                let column = &self.scaled.directions[self.basis[k]].vector;
                (dot(row, column) - f64::from(u8::from(i == k))).abs()
            };
            (0..rank).all(|k| off(k) <= 1e-3)
        })
    }
}
