//! Elimination in rationals: inverses, solutions and dependences.

use crate::numeric::Rational;

/// The coefficients with Σ x_k column_k = right; `None` if the columns are dependent or nothing solves the equations.
pub(crate) fn solve(columns: &[Vec<Rational>], right: &[Rational]) -> Option<Vec<Rational>> {
    let count = columns.len();
    let row = |axis: usize| columns.iter().map(|c| c[axis].clone()).chain([right[axis].clone()]).collect();
    let mut rows: Vec<Vec<Rational>> = (0..right.len()).map(row).collect();
    reduce(&mut rows, count).ok()?;
    let (solved, over) = rows.split_at_mut(count);
    let is_solution = over.iter().all(|row| row[count].is_zero());
    is_solution.then(|| solved.iter_mut().map(|row| row.swap_remove(count)).collect())
}

/// The inverse of a square matrix, row by row; `None` if it is singular.
pub(crate) fn inverse(matrix: Vec<Vec<Rational>>) -> Option<Vec<Vec<Rational>>> {
    let size = matrix.len();
    let mut rows = matrix;
    for (i, row) in rows.iter_mut().enumerate() {
        row.extend((0..size).map(|k| if k == i { Rational::ONE } else { Rational::ZERO }));
    }
    reduce(&mut rows, size).ok()?;
    Some(rows.into_iter().map(|mut row| row.split_off(size)).collect())
}

/// The dependence of vectors all but the last of which are independent: Σ c_k vector_k = 0 with c = 1 for the last;
/// `None` when all are independent.
pub(crate) fn dependence(vectors: &[Vec<Rational>]) -> Option<Vec<Rational>> {
    let (last, others) = vectors.split_last()?;
    let coefficients = solve(others, last)?;
    Some(coefficients.into_iter().map(|c| -c).chain([Rational::ONE]).collect())
}

/// Turns the first `columns` columns of a matrix into those of the identity by row operations, column by column; the
/// first column that depends on those before it, if there is one, ends it. O(rows · columns) row operations.
fn reduce(rows: &mut [Vec<Rational>], columns: usize) -> Result<(), usize> {
    for column in 0..columns {
        let found = (column..rows.len()).find(|&row| !rows[row][column].is_zero()).ok_or(column)?;
        rows.swap(column, found);
        let head = rows[column][column].clone();
        rows[column].iter_mut().for_each(|v| *v /= &head);
        let reduced = rows[column].clone();
        for row in rows.iter_mut().enumerate().filter(|(r, _)| *r != column).map(|(_, row)| row) {
            let factor = row[column].clone();
            if !factor.is_zero() {
                row.iter_mut().zip(&reduced).for_each(|(a, b)| *a -= &factor * b);
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix<const R: usize, const C: usize>(rows: [[i64; C]; R]) -> Vec<Vec<Rational>> {
        rows.map(|row| row.map(Rational::from).to_vec()).to_vec()
    }

    #[test]
    fn a_system_worked_out_by_hand() {
        // 2 x + y = 4, x − y = −1: x = 1, y = 2
        let columns = matrix([[2, 1], [1, -1]]);
        assert_eq!(solve(&columns, &[4, -1].map(Rational::from)), Some([1, 2].map(Rational::from).to_vec()));
        let mut rows = matrix([[2, 1, 4], [1, -1, -1]]);
        assert_eq!(reduce(&mut rows, 2), Ok(()));
        assert_eq!(rows, matrix([[1, 0, 1], [0, 1, 2]]));
    }

    #[test]
    fn what_has_no_solution_or_more_than_one_has_none() {
        let right = [1, 1, 1].map(Rational::from);
        assert_eq!(solve(&matrix([[1, 0, 0], [0, 1, 0]]), &right), None);
        assert_eq!(solve(&matrix([[1, 1, 1], [2, 2, 2]]), &right), None);
        assert_eq!(solve(&matrix([[2, 2, 2]]), &right), Some(vec![Rational::from_parts(1.into(), 2u8.into())]));
        assert_eq!(solve(&[], &[Rational::ZERO]), Some(Vec::new()));
        assert_eq!(solve(&[], &[Rational::ONE]), None);
    }

    #[test]
    fn an_inverse_and_a_dependence_by_hand() {
        assert_eq!(inverse(matrix([[0, 1], [-1, 3]])), Some(matrix([[3, -1], [1, 0]])));
        assert_eq!(inverse(matrix([[1, 2], [2, 4]])), None);
        let vectors = matrix([[1, 0, 0], [0, 1, 0], [2, -3, 0]]);
        assert_eq!(dependence(&vectors), Some([-2, 3, 1].map(Rational::from).to_vec()));
        assert_eq!(dependence(&matrix([[1, 0], [0, 1]])), None);
        assert_eq!(dependence(&matrix([[0, 0]])), Some(vec![Rational::ONE]));
        assert_eq!(reduce(&mut matrix([[2, 4, 1], [1, 2, 1]]), 3), Err(1));
    }
}
