//! Inverses of matrices of doubles, by Gauss–Jordan elimination with row pivoting.

use super::add_multiple;

/// The inverse of the leading `rank` × `rank` square of a matrix, 0 elsewhere; `None` if it is singular or its inverse
/// leaves the doubles.
pub(crate) fn inverse<const D: usize>(rank: usize, matrix: &[[f64; D]; D]) -> Option<[[f64; D]; D]> {
    let mut left = *matrix;
    let mut right = std::array::from_fn(|i| std::array::from_fn(|k| f64::from(u8::from(i == k && i < rank))));
    invert(&mut left, &mut right, rank)?;
    right.iter().flatten().all(|c| c.is_finite()).then_some(right)
}

/// Makes the leading `rank` × `rank` square of `left` the identity by row operations, and does the same to the rows of
/// `right`: an identity there becomes the inverse, a column b becomes the solution of left · x = b. `None` if a pivot
/// is 0 or not finite. O(rank²) row operations.
pub(crate) fn invert<Row: AsMut<[f64]>>(left: &mut [Row], right: &mut [Row], rank: usize) -> Option<()> {
    for column in 0..rank {
        let size = |left: &mut [Row], row: usize| left[row].as_mut()[column].abs();
        let mut pivot = column;
        for row in column + 1..rank {
            // of equal ones the last
            if size(left, row).total_cmp(&size(left, pivot)).is_ge() {
                pivot = row;
            }
        }
        let head = left[pivot].as_mut()[column];
        if head == 0.0 || !head.is_finite() {
            return None;
        }
        left.swap(column, pivot);
        right.swap(column, pivot);
        left[column].as_mut().iter_mut().chain(right[column].as_mut()).for_each(|c| *c /= head);
        for row in (0..rank).filter(|&row| row != column) {
            let factor = left[row].as_mut()[column];
            if factor != 0.0 {
                // what is left of the column was made the identity already
                subtract_multiple(left, row, factor, column, column);
                subtract_multiple(right, row, factor, column, 0);
            }
        }
    }
    Some(())
}

/// Subtracts a multiple of one row from another, from a column on.
fn subtract_multiple<Row: AsMut<[f64]>>(rows: &mut [Row], row: usize, factor: f64, from: usize, first: usize) {
    let [row, from] = rows.get_disjoint_mut([row, from]).expect("two different rows of the matrix");
    add_multiple(&mut row.as_mut()[first..], -factor, &from.as_mut()[first..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_by_hand() {
        assert_eq!(inverse(2, &[[0.0, 2.0], [4.0, 0.0]]), Some([[0.0, 0.25], [0.5, 0.0]]));
        assert_eq!(inverse(1, &[[4.0, 9.0], [9.0, 9.0]]), Some([[0.25, 0.0], [0.0, 0.0]]));
        assert_eq!(inverse(2, &[[1.0, 2.0], [2.0, 4.0]]), None);
        assert_eq!(inverse(1, &[[f64::NAN]]), None);
        assert_eq!(inverse(1, &[[f64::from_bits(1)]]), None);
    }

    #[test]
    fn a_system_of_many_rows_is_solved() {
        let size = 9;
        let entry = |i: usize, k: usize| if i == k { 10.0 } else { ((3 * i + 5 * k) % 7) as f64 };
        let mut left: Vec<Vec<f64>> = (0..size).map(|i| (0..size).map(|k| entry(i, k)).collect()).collect();
        // the right-hand side for x = (1, 2, …, 9)
        let mut right: Vec<Vec<f64>> =
            (0..size).map(|i| vec![(0..size).map(|k| entry(i, k) * (k + 1) as f64).sum()]).collect();
        assert_eq!(invert(&mut left, &mut right, size), Some(()));
        assert!(right.iter().enumerate().all(|(k, x)| (x[0] - (k + 1) as f64).abs() < 1e-12));
    }

    #[test]
    fn pivots_that_are_zero_or_not_finite_end_the_elimination() {
        for entry in [0.0, f64::INFINITY, f64::NAN] {
            assert_eq!(invert(&mut [[entry]], &mut [[1.0]], 1), None, "{entry}");
        }
    }
}
