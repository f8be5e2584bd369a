//! Linear programs of a few unknowns in doubles, whose answers are only guesses.
//!
//! The program is to minimise costs · x over x ≥ 0 with A x ≥ b, where no cost is negative. Its dual, to maximise b · y
//! over y ≥ 0 with Aᵀ y ≤ costs, begins at y = 0. The method is the simplex method on the dense table of the dual: it
//! has a row for each unknown and a column for each inequality, some hundred entries in one block of memory. The
//! enclosing programs of a caller's points (`enclosing::fixed_directions`) are larger, keep a basis while inequalities
//! are added, and end in a proof; a fit solves several programs for each node and proves nothing but the last body.

use fearless_simd::{Simd, dispatch};

use crate::numeric::lanes::level::level_for_few;

/// A gain of a column below this counts as rounding.
const LEAST_GAIN: f64 = 1e-12;

/// An entry below this is no pivot.
const LEAST_PIVOT: f64 = 1e-9;

/// The perturbation of a cost: it keeps ties from stalling the method.
const PERTURBATION: f64 = 1e-9;

/// Pivots after which the method gives up, for each unknown.
const PIVOTS_OF_AN_UNKNOWN: usize = 12;

/// Columns side by side. Rows are filled up with columns without a gain, which never enter.
const LANES: usize = 8;

/// The table of the dual of a program.
pub(super) struct Program {
    unknowns: usize,
    inequalities: usize,
    /// Aᵀ at first: a row for each unknown, as long as `gains`.
    entries: Vec<f64>,
    /// b at first: the gain of each column.
    gains: Vec<f64>,
}

impl Program {
    /// The program without an inequality, with room for a number of them.
    pub(super) fn with_room(unknowns: usize, inequalities: usize) -> Self {
        let columns = inequalities.next_multiple_of(LANES);
        Self { unknowns, inequalities: 0, entries: vec![0.0; unknowns * columns], gains: vec![0.0; columns] }
    }

    /// Adds the inequality coefficients · x ≥ right.
    #[inline]
    pub(super) fn add_inequality(&mut self, coefficients: impl IntoIterator<Item = f64>, right: f64) {
        let columns = self.gains.len();
        for (row, c) in coefficients.into_iter().enumerate() {
            self.entries[row * columns + self.inequalities] = c;
        }
        self.gains[self.inequalities] = right;
        self.inequalities += 1;
    }

    /// An optimal x; `None` where there is none or rounding hides it.
    pub(super) fn minimize(mut self, costs: &[f64]) -> Option<Vec<f64>> {
        assert_eq!(self.unknowns, costs.len());
        dispatch!(level_for_few(), simd => self.run(simd, costs))
    }

    #[inline(always)]
    fn run<S: Simd>(&mut self, _simd: S, costs: &[f64]) -> Option<Vec<f64>> {
        let (rows, columns) = (self.unknowns, self.gains.len());
        let spread = |i: usize| ((i + 1) as f64 * 0.618_033_988_749_894_9).fract();
        let mut values: Vec<f64> =
            costs.iter().enumerate().map(|(i, cost)| cost + PERTURBATION * (1.0 + spread(i))).collect();
        // variables from 0 are those of the dual, then its slacks, whose prices are x
        let mut of_rows: Vec<usize> = (columns..columns + rows).collect();
        let mut of_columns: Vec<usize> = (0..columns).collect();
        let mut pivot_row = vec![0.0; columns];
        for _ in 0..PIVOTS_OF_AN_UNKNOWN * rows + 20 {
            let Some(entering) = self.entering() else {
                let mut x = vec![0.0; rows];
                for (&variable, &gain) in of_columns.iter().zip(&self.gains) {
                    if variable >= columns {
                        x[variable - columns] = (-gain).max(0.0);
                    }
                }
                return Some(x);
            };
            let leaving = self.leaving(entering, &values)?;
            // the entering variable takes the row, the leaving one the column
            let head = 1.0 / self.entries[leaving * columns + entering];
            let row = &mut self.entries[leaving * columns..(leaving + 1) * columns];
            row.iter_mut().for_each(|entry| *entry *= head);
            row[entering] = head;
            pivot_row.copy_from_slice(row);
            let step = values[leaving] * head;
            values[leaving] = step;
            for (at, row) in self.entries.chunks_exact_mut(columns).enumerate() {
                let factor = row[entering];
                if at != leaving && factor != 0.0 {
                    row[entering] = 0.0;
                    row.iter_mut().zip(&pivot_row).for_each(|(entry, p)| *entry -= factor * p);
                    values[at] = (values[at] - factor * step).max(0.0);
                }
            }
            let factor = self.gains[entering];
            self.gains[entering] = 0.0;
            self.gains.iter_mut().zip(&pivot_row).for_each(|(gain, p)| *gain -= factor * p);
            std::mem::swap(&mut of_rows[leaving], &mut of_columns[entering]);
        }
        None
    }

    /// The first column of the largest gain.
    #[inline(always)]
    fn entering(&self) -> Option<usize> {
        let mut largest = [LEAST_GAIN; LANES];
        for gains in self.gains.as_chunks::<LANES>().0 {
            for (largest, &gain) in largest.iter_mut().zip(gains) {
                *largest = if gain > *largest { gain } else { *largest };
            }
        }
        let largest = largest.into_iter().fold(LEAST_GAIN, f64::max);
        if largest > LEAST_GAIN { self.gains.iter().position(|&gain| gain == largest) } else { None }
    }

    /// The row that is first at zero as a column grows; of several, the one with the largest entry.
    #[inline(always)]
    fn leaving(&self, entering: usize, values: &[f64]) -> Option<usize> {
        let mut best: Option<(f64, f64, usize)> = None;
        for (row, value) in values.iter().enumerate() {
            let entry = self.entries[row * self.gains.len() + entering];
            if entry > LEAST_PIVOT {
                let ratio = value / entry;
                if best.is_none_or(|(least, largest, _)| ratio < least || ratio == least && entry > largest) {
                    best = Some((ratio, entry, row));
                }
            }
        }
        best.map(|(.., row)| row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_by_hand() {
        // x + 2 y ≥ 4 and 3 x + y ≥ 6 meet at (1.6, 1.2)
        let mut program = Program::with_room(2, 2);
        program.add_inequality([1.0, 2.0], 4.0);
        program.add_inequality([3.0, 1.0], 6.0);
        let x = program.minimize(&[1.0, 1.0]).expect("it has an optimum");
        assert!((x[0] - 1.6).abs() < 1e-9 && (x[1] - 1.2).abs() < 1e-9, "{x:?}");
    }

    #[test]
    fn inequalities_that_contradict_have_no_optimum() {
        let mut program = Program::with_room(1, 2);
        program.add_inequality([1.0], 2.0);
        program.add_inequality([-1.0], -1.0);
        assert_eq!(program.minimize(&[1.0]), None);
    }
}
