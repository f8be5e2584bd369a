//! Elimination in rationals: what settling and solving for a basis share.

use crate::numeric::Rational;

/// Turns the first `columns` columns of a matrix into those of the identity by row operations, column by column; the first column that depends on
/// those before it, if there is one, ends it. O(rows² · columns) for each row's length.
pub(super) fn reduce(rows: &mut [Vec<Rational>], columns: usize) -> Result<(), usize> {
    for column in 0..columns {
        let found = (column..rows.len()).find(|&row| rows[row][column] != Rational::ZERO).ok_or(column)?;
        rows.swap(column, found);
        let pivot = rows[column][column].clone();
        rows[column].iter_mut().for_each(|v| *v /= &pivot);
        let reduced = rows[column].clone();
        for row in rows.iter_mut().enumerate().filter(|(r, _)| *r != column).map(|(_, row)| row) {
            let factor = row[column].clone();
            row.iter_mut().zip(&reduced).for_each(|(a, b)| *a -= &factor * b);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: [[i64; 3]; 2]) -> Vec<Vec<Rational>> {
        rows.map(|row| row.map(Rational::from).to_vec()).to_vec()
    }

    #[test]
    fn a_system_worked_out_by_hand() {
        // 2 x + y = 4, x − y = −1: x = 1, y = 2
        let mut rows = matrix([[2, 1, 4], [1, -1, -1]]);
        assert_eq!(reduce(&mut rows, 2), Ok(()));
        assert_eq!(rows, matrix([[1, 0, 1], [0, 1, 2]]));
    }

    #[test]
    fn a_dependent_column_is_named() {
        let mut rows = matrix([[2, 4, 1], [1, 2, 1]]);
        assert_eq!(reduce(&mut rows, 3), Err(1));
    }
}
