//! Symmetric positive definite systems of equations, dense.

use wide::f64x2;

/// A pivot smaller than this beside its entry is rounding: its unknown depends on the others, and stays zero.
const NOTHING: f64 = 1e-15;

/// A pivot that keeps an unknown at zero.
const IMMOVABLE: f64 = 1e100;

/// Rows that are worked on together: each earlier row is read once for all of them.
const PANEL: usize = 16;

/// Rows whose products with two others are summed side by side.
const BLOCK: usize = 4;

/// The lower half of a symmetric matrix, row after row, filled up with rows of the identity.
pub(super) struct Cholesky {
    unknowns: usize,
    size: usize,
    entries: Vec<f64>,
}

/// The Cholesky factor of a matrix.
pub(super) struct Factor(Cholesky);

impl Cholesky {
    pub(super) fn zero(unknowns: usize) -> Self {
        let size = unknowns.next_multiple_of(BLOCK);
        let mut matrix = Self { unknowns, size, entries: vec![0.0; size * size] };
        for row in unknowns..size {
            matrix.set(row, row, 1.0);
        }
        matrix
    }

    /// Sets an entry that is not above the diagonal.
    pub(super) fn set(&mut self, row: usize, column: usize, entry: f64) {
        self.entries[row * self.size + column] = entry;
    }

    fn row(&self, row: usize, end: usize) -> &[f64] {
        &self.entries[row * self.size..][..end]
    }

    /// The factor; `None` if the matrix has no positive diagonal.
    pub(super) fn factor(mut self) -> Option<Factor> {
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

    /// The factor's entries in two columns, for a block of rows below them.
    fn eliminate(&mut self, row: usize, column: usize) {
        let rows = std::array::from_fn(|i| self.row(row + i, column));
        let sums = products(rows, self.row(column, column), self.row(column + 1, column));
        let [pivot, below, next] =
            [(column, column), (column + 1, column), (column + 1, column + 1)].map(|(r, c)| self.row(r, c + 1)[c]);
        for (i, [a, b]) in sums.into_iter().enumerate() {
            let entries = &mut self.entries[(row + i) * self.size + column..][..2];
            entries[0] = (entries[0] - a) / pivot;
            entries[1] = (entries[1] - b - entries[0] * below) / next;
        }
    }

    /// The rest of a row, from the column at which its block begins.
    fn finish(&mut self, row: usize, block: usize) -> Option<()> {
        for column in block..row {
            let rest = self.row(row, row)[column] - product(self.row(row, column), self.row(column, column));
            let entry = rest / self.row(column, column + 1)[column];
            self.set(row, column, entry);
        }
        let diagonal = self.row(row, row + 1)[row];
        let square = diagonal - product(self.row(row, row), self.row(row, row));
        if square.is_nan() || diagonal <= 0.0 {
            return None;
        }
        self.set(row, row, if square > NOTHING * diagonal { square.sqrt() } else { IMMOVABLE });
        Some(())
    }
}

impl Factor {
    /// The solution for a right side.
    pub(super) fn solve(&self, right: &[f64]) -> Vec<f64> {
        let Self(matrix) = self;
        let mut x = right.to_vec();
        for row in 0..matrix.unknowns {
            x[row] = (x[row] - product(matrix.row(row, row), &x[..row])) / matrix.row(row, row + 1)[row];
        }
        for row in (0..matrix.unknowns).rev() {
            x[row] /= matrix.row(row, row + 1)[row];
            let value = x[row];
            for (x, v) in x[..row].iter_mut().zip(matrix.row(row, row)) {
                *x -= value * v;
            }
        }
        x
    }
}

/// The sums of products of four rows with two others, of even length.
fn products([p, q, r, s]: [&[f64]; BLOCK], a: &[f64], b: &[f64]) -> [[f64; 2]; BLOCK] {
    let mut sums = [[f64x2::ZERO; 2]; BLOCK];
    let [p, q, r, s, a, b] = [p, q, r, s, a, b].map(|row| row.as_chunks::<2>().0);
    for (((((p, q), r), s), a), b) in p.iter().zip(q).zip(r).zip(s).zip(a).zip(b) {
        let (a, b) = (f64x2::from(*a), f64x2::from(*b));
        for (sums, row) in sums.iter_mut().zip([p, q, r, s]) {
            let row = f64x2::from(*row);
            sums[0] += row * a;
            sums[1] += row * b;
        }
    }
    sums.map(|pair| pair.map(|sum| sum.to_array().iter().sum()))
}

/// The sum of products, in eight partial sums.
fn product(a: &[f64], b: &[f64]) -> f64 {
    let (mut a, mut b) = (a.chunks_exact(8), b.chunks_exact(8));
    let mut sums = [0.0; 8];
    for (x, y) in a.by_ref().zip(b.by_ref()) {
        for i in 0..8 {
            sums[i] += x[i] * y[i];
        }
    }
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_by_hand() {
        let mut matrix = Cholesky::zero(2);
        for (row, column, entry) in [(0, 0, 2.0), (1, 0, 2.0), (1, 1, 5.0)] {
            matrix.set(row, column, entry);
        }
        let x = matrix.factor().expect("positive definite").solve(&[4.0, 7.0]);
        assert!((x[0] - 1.0).abs() < 1e-15 && (x[1] - 1.0).abs() < 1e-15, "{x:?}");
        assert!(Cholesky::zero(1).factor().is_none());
    }

    #[test]
    fn the_solution_of_the_least_of_two_indices() {
        // min(i, j) + 1 is the covariance of sums of i + 1 steps: the inverse is that of second differences
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
}
