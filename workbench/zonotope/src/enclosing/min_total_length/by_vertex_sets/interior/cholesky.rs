//! Dense symmetric positive semidefinite systems of equations, by a blocked Cholesky factorisation.
//!
//! The factorisation leaves an unknown at zero if its row depends on the rows before it, where a plain factorisation
//! fails; and it works in any [`Scalar`], also in pairs of doubles. For these two reasons no library is used.

use crate::enclosing::min_total_length::by_vertex_sets::scalar::{BLOCK, Scalar};

/// The pivot of an unknown whose row depends on the rows before it: so large that the unknown becomes zero.
const DEPENDENT_PIVOT: f64 = 1e100;

/// The number of rows that are factored together: each earlier row is read once for all of them.
const PANEL: usize = 16;

/// The lower half of a symmetric matrix, row after row. Rows of the identity fill it up to a whole number of blocks.
pub(super) struct Cholesky<R> {
    unknowns: usize,
    size: usize,
    entries: Vec<R>,
}

/// The Cholesky factor of a matrix.
pub(super) struct Factor<R>(Cholesky<R>);

impl<R: Scalar> Cholesky<R> {
    /// The zero matrix for a number of unknowns.
    pub(super) fn zero(unknowns: usize) -> Self {
        let size = unknowns.next_multiple_of(BLOCK);
        let mut matrix = Self { unknowns, size, entries: vec![R::from(0.0); size * size] };
        for row in unknowns..size {
            matrix.set(row, row, R::from(1.0));
        }
        matrix
    }

    /// Sets an entry that is not above the diagonal.
    pub(super) fn set(&mut self, row: usize, column: usize, entry: R) {
        self.entries[row * self.size + column] = entry;
    }

    /// The entries of a row before the column `end`.
    fn row(&self, row: usize, end: usize) -> &[R] {
        &self.entries[row * self.size..][..end]
    }

    /// The factor; `None` if a diagonal entry is not positive, or an entry is not a number.
    pub(super) fn factor(mut self) -> Option<Factor<R>> {
        for panel in (0..self.size).step_by(PANEL) {
            let end = (panel + PANEL).min(self.size);
            for column in (0..panel).step_by(2) {
                for row in (panel..end).step_by(BLOCK) {
                    self.eliminate(row, column);
                }
            }
            for block in (panel..end).step_by(BLOCK) {
                for column in (panel..block).step_by(2) {
                    self.eliminate(block, column);
                }
                for row in block..block + BLOCK {
                    self.finish(row, block)?;
                }
            }
        }
        Some(Factor(self))
    }

    /// Computes the factor's entries in two columns, for a block of rows whose columns before these are done.
    fn eliminate(&mut self, row: usize, column: usize) {
        let rows = std::array::from_fn(|i| self.row(row + i, column));
        let sums = R::products(rows, [self.row(column, column), self.row(column + 1, column)]);
        let [pivot, below, next] =
            [(column, column), (column + 1, column), (column + 1, column + 1)].map(|(r, c)| self.row(r, c + 1)[c]);
        for (i, [a, b]) in sums.into_iter().enumerate() {
            let entries = &mut self.entries[(row + i) * self.size + column..][..2];
            entries[0] = (entries[0] - a) / pivot;
            entries[1] = (entries[1] - b - entries[0] * below) / next;
        }
    }

    /// Computes the rest of a row of the factor, from the column at which its block begins to the diagonal. `None` if
    /// the matrix's diagonal entry is not positive, or the pivot is not a number.
    fn finish(&mut self, row: usize, block: usize) -> Option<()> {
        for column in block..row {
            let rest = self.row(row, row)[column] - R::row_product(self.row(row, column), self.row(column, column));
            let entry = rest / self.row(column, column + 1)[column];
            self.set(row, column, entry);
        }
        let diagonal = self.row(row, row + 1)[row];
        let square = diagonal - R::row_product(self.row(row, row), self.row(row, row));
        if square.value().is_nan() || diagonal.value() <= 0.0 {
            return None;
        }
        let least = R::from(R::PIVOT_TOLERANCE) * diagonal;
        self.set(row, row, if square > least { square.sqrt() } else { R::from(DEPENDENT_PIVOT) });
        Some(())
    }
}

impl<R: Scalar> Factor<R> {
    /// The solution of the equations for a right side.
    pub(super) fn solve(&self, right: &[R]) -> Vec<R> {
        let Self(matrix) = self;
        let mut x = right.to_vec();
        for row in 0..matrix.unknowns {
            x[row] = (x[row] - R::row_product(matrix.row(row, row), &x[..row])) / matrix.row(row, row + 1)[row];
        }
        for row in (0..matrix.unknowns).rev() {
            x[row] = x[row] / matrix.row(row, row + 1)[row];
            let value = x[row];
            for (x, v) in x[..row].iter_mut().zip(matrix.row(row, row)) {
                *x = *x - value * *v;
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::double_double::DoubleDouble;

    #[test]
    fn a_solution_by_hand() {
        let mut matrix: Cholesky<f64> = Cholesky::zero(2);
        for (row, column, entry) in [(0, 0, 2.0), (1, 0, 2.0), (1, 1, 5.0)] {
            matrix.set(row, column, entry);
        }
        let x = matrix.factor().expect("positive definite").solve(&[4.0, 7.0]);
        assert!((x[0] - 1.0).abs() < 1e-15 && (x[1] - 1.0).abs() < 1e-15, "{x:?}");
        assert!(Cholesky::<f64>::zero(1).factor().is_none());
    }

    #[test]
    fn the_solution_of_the_least_of_two_indices() {
        // The entries are min(i, j) + 1; the inverse of such a matrix takes second differences.
        for size in [1, 3, 4, 17, 50] {
            let mut matrix = Cholesky::zero(size);
            for row in 0..size {
                for column in 0..=row {
                    matrix.set(row, column, (column + 1) as f64);
                }
            }
            let right: Vec<f64> = (1..=size).map(|i| (i * i) as f64).collect();
            let x = matrix.factor().expect("positive definite").solve(&right);
            for (i, x) in x.iter().enumerate() {
                let truth = if i + 1 < size { -2.0 } else { (2 * size - 1) as f64 };
                assert!((x - truth).abs() < 1e-9, "{size} {i} {x}");
            }
        }
    }

    #[test]
    fn pairs_solve_what_doubles_cannot() {
        // Hilbert's matrix of 1 / (i + j + 1), scaled to whole numbers; its condition number is 10^16 for twelve
        // unknowns.
        let size = 12;
        let multiple = (1..2 * size as u64).fold(1, |m, k| m * k / greatest_divisor(m, k));
        let off = |x: &[f64]| x.iter().map(|x| (x - 1.0).abs()).fold(0.0, f64::max);
        let in_pairs = solved::<DoubleDouble>(size, multiple);
        assert!(off(&in_pairs) < 1e-12, "{in_pairs:?}");
        assert!(off(&solved::<f64>(size, multiple)) > 1e-6);
    }

    fn solved<R: Scalar>(size: usize, multiple: u64) -> Vec<f64> {
        let mut matrix: Cholesky<R> = Cholesky::zero(size);
        let entry = |i: usize, j: usize| multiple / (i + j + 1) as u64;
        for row in 0..size {
            for column in 0..=row {
                matrix.set(row, column, R::from(entry(row, column) as f64));
            }
        }
        let right: Vec<R> = (0..size).map(|i| R::from((0..size).map(|j| entry(i, j)).sum::<u64>() as f64)).collect();
        matrix.factor().expect("positive definite").solve(&right).into_iter().map(R::value).collect()
    }

    fn greatest_divisor(a: u64, b: u64) -> u64 {
        if b == 0 { a } else { greatest_divisor(b, a % b) }
    }
}
