//! The inverse of the basis, values and prices, computed anew.
//!
//! The basic slacks are columns of the identity. So only a block has to be inverted, that of the basic normals and of
//! the tight constraints, which have no basic slack.

use super::{Basic, NormalProgram, Stuck};
use crate::numeric::lanes::product_in_fours;
use crate::numeric::linear::{add_multiple, invert};

/// The number of times that values and prices are refined by the residuals of their equations.
const REFINEMENTS: usize = 2;

impl<const D: usize> NormalProgram<D> {
    /// Computes inverse, values and prices anew.
    pub(super) fn refactor(&mut self) -> Result<(), Stuck> {
        let size = self.size();
        let normals: Vec<(usize, usize)> = self
            .basis
            .iter()
            .enumerate()
            .filter_map(|(at, b)| if let Basic::Normal(j) = b { Some((at, *j)) } else { None })
            .collect();
        let tight: Vec<usize> =
            (0..size).filter(|&i| i.checked_sub(self.rank).is_none_or(|i| !self.slack_is_basic[i])).collect();
        if tight.len() != normals.len() {
            return Err(Stuck);
        }
        // Row t of the block holds the entries of tight constraint t for the basic normals.
        let mut left: Vec<Vec<f64>> =
            tight.iter().map(|&t| normals.iter().map(|&(_, j)| self.entries[j][t]).collect()).collect();
        let unit = |i: usize| (0..tight.len()).map(|j| f64::from(u8::from(i == j))).collect();
        let mut block: Vec<Vec<f64>> = (0..tight.len()).map(unit).collect();
        // The elimination reads both blocks for every row of them, and each slack's row is made from the inverse block.
        self.entries_read += (size as u64 + tight.len() as u64) * (tight.len() as u64).pow(2);
        invert(&mut left, &mut block, tight.len()).ok_or(Stuck)?;
        let mut inverse = vec![vec![0.0; size]; size];
        for (&(at, _), row) in normals.iter().zip(&block) {
            for (&t, &v) in tight.iter().zip(row) {
                inverse[at][t] = v;
            }
        }
        for (at, basic) in self.basis.iter().enumerate() {
            let Basic::Slack(i) = basic else { continue };
            let constraint = self.rank + i;
            let mut row = vec![0.0; tight.len()];
            for (&(_, j), inverse_row) in normals.iter().zip(&block) {
                let entry = self.entries[j][constraint];
                for (sum, v) in row.iter_mut().zip(inverse_row) {
                    *sum -= entry * v;
                }
            }
            for (&t, v) in tight.iter().zip(row) {
                inverse[at][t] = v;
            }
            inverse[at][constraint] = 1.0;
        }
        self.inverse = inverse;
        self.values = self.solve_values();
        let mut prices = vec![0.0; size];
        for &(at, j) in &normals {
            add_multiple(&mut prices, self.rows[j].height, &self.inverse[at]);
        }
        // Values are refined by the residuals of the tight constraints, prices by those of the basic normals.
        for _ in 0..REFINEMENTS {
            let missing = |&t: &usize| {
                self.bound(t) - normals.iter().map(|&(at, j)| self.values[at] * self.entries[j][t]).sum::<f64>()
            };
            let missing: Vec<f64> = tight.iter().map(missing).collect();
            for (&(at, _), row) in normals.iter().zip(&block) {
                self.values[at] += product_in_fours(row, &missing);
            }
            let missing = |&(_, j): &(usize, usize)| self.rows[j].height - product_in_fours(&self.entries[j], &prices);
            let missing: Vec<f64> = normals.iter().map(missing).collect();
            for (&(at, _), miss) in normals.iter().zip(missing) {
                add_multiple(&mut prices, miss, &self.inverse[at]);
            }
        }
        self.prices = prices;
        self.pivots_since_inverse = 0;
        if self.prices.iter().chain(&self.values).all(|v| v.is_finite()) { Ok(()) } else { Err(Stuck) }
    }
}
