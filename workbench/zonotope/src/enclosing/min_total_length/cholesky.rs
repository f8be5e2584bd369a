//! Symmetric positive definite systems of equations, dense.

/// A pivot smaller than this beside its entry is rounding: its unknown depends on the others, and stays zero.
const NOTHING: f64 = 1e-15;

/// A pivot that keeps an unknown at zero.
const IMMOVABLE: f64 = 1e100;

/// Rows that are worked on together, so that each earlier row is read once for all of them.
const PANEL: usize = 8;

/// The lower half of a symmetric matrix, row after row; solved by its Cholesky factor.
pub(super) struct Cholesky {
    size: usize,
    entries: Vec<f64>,
}

impl Cholesky {
    pub(super) fn zero(size: usize) -> Self {
        Self { size, entries: vec![0.0; size * size] }
    }

    /// Adds one symmetric block at every pair of places.
    pub(super) fn add_blocks(&mut self, places: &[usize], width: usize, block: &[f64]) {
        for (i, &row) in places.iter().enumerate() {
            for (a, part) in block.chunks_exact(width).enumerate() {
                let line = &mut self.entries[(row + a) * self.size..][..self.size];
                for &column in &places[..=i] {
                    for (entry, v) in line[column..column + width].iter_mut().zip(part) {
                        *entry += v;
                    }
                }
            }
        }
    }

    /// The solution for a right side; `None` if the matrix has no positive diagonal.
    pub(super) fn solve(mut self, right: &[f64]) -> Option<Vec<f64>> {
        let size = self.size;
        for panel in (0..size).step_by(PANEL) {
            let end = (panel + PANEL).min(size);
            let (before, rest) = self.entries.split_at_mut(panel * size);
            for (column, other) in before.chunks_exact(size).enumerate() {
                for line in rest.chunks_exact_mut(size).take(end - panel) {
                    line[column] = (line[column] - product(&line[..column], &other[..column])) / other[column];
                }
            }
            for row in panel..end {
                let (before, rest) = rest.split_at_mut((row - panel) * size);
                let line = &mut rest[..=row];
                for (column, other) in (panel..row).zip(before.chunks_exact(size)) {
                    line[column] = (line[column] - product(&line[..column], &other[..column])) / other[column];
                }
                let square = line[row] - product(&line[..row], &line[..row]);
                if square.is_nan() || line[row] <= 0.0 {
                    return None;
                }
                line[row] = if square > NOTHING * line[row] { square.sqrt() } else { IMMOVABLE };
            }
        }
        let mut x = right.to_vec();
        for row in 0..size {
            let line = &self.entries[row * size..][..=row];
            x[row] = (x[row] - product(&line[..row], &x[..row])) / line[row];
        }
        for row in (0..size).rev() {
            let line = &self.entries[row * size..][..=row];
            x[row] /= line[row];
            let value = x[row];
            for (x, v) in x[..row].iter_mut().zip(line) {
                *x -= value * v;
            }
        }
        Some(x)
    }
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
    fn blocks_and_a_solution_by_hand() {
        // [[2, 1], [1, 2]] of blocks of one, and one more on the second place: [[2, 2], [2, 5]]
        let mut matrix = Cholesky::zero(2);
        matrix.add_blocks(&[0, 1], 1, &[2.0]);
        matrix.add_blocks(&[1], 1, &[3.0]);
        let x = matrix.solve(&[4.0, 7.0]).expect("positive definite");
        assert!((x[0] - 1.0).abs() < 1e-15 && (x[1] - 1.0).abs() < 1e-15, "{x:?}");
        assert!(Cholesky::zero(1).solve(&[1.0]).is_none());
    }
}
