//! Determinants, and normals of hyperplanes, by expansion along rows.
//!
//! All minors of the last k rows are made from those of the last k − 1, so that each is computed once: with d columns
//! 2^(d−1) d products at most, against d! of a plain expansion. There are no divisions; elimination needs fewer
//! operations from about seven columns on, which no method here comes near.

use super::Ring;

/// det(rows), of as many rows as columns; 1 for none.
pub(crate) fn determinant<T: Ring, Row: AsRef<[T]>>(rows: &[Row]) -> T {
    let dimension = rows.len();
    let minors = minors_of_all_rows(rows, dimension);
    minors[(1 << dimension) - 1].clone()
}

/// The vector u with u · v = det(v, rows) for every v, of d − 1 rows of d columns: the cross product of d − 1 vectors.
/// It is orthogonal to all of them, and 0 just when they are dependent.
pub(crate) fn hyperplane_normal<T: Ring, Row: AsRef<[T]>>(rows: &[Row]) -> Vec<T> {
    let dimension = rows.len() + 1;
    let minors = minors_of_all_rows(rows, dimension);
    let all = (1usize << dimension) - 1;
    let signed = |axis: usize| {
        let minor = &minors[all ^ (1 << axis)];
        if axis.is_multiple_of(2) { minor.clone() } else { T::ZERO.minus(minor) }
    };
    (0..dimension).map(signed).collect()
}

/// By sets of columns, as bits: the determinant of these columns of the last rows, of as many as there are columns in
/// the set.
fn minors_of_all_rows<T: Ring, Row: AsRef<[T]>>(rows: &[Row], dimension: usize) -> Vec<T> {
    assert!(dimension <= 16, "vectors have few coordinates");
    let mut minors = vec![T::ONE; 1 << dimension];
    for (below, row) in rows.iter().rev().enumerate() {
        let row = row.as_ref();
        for set in (0..1usize << dimension).filter(|set| set.count_ones() as usize == below + 1) {
            let mut sum: Option<T> = None;
            let mut is_added = true;
            for column in (0..dimension).filter(|column| set & (1 << column) != 0) {
                let entry = &row[column];
                if !entry.is_exactly_zero() {
                    let term = entry.times(&minors[set ^ (1 << column)]);
                    sum = Some(match sum {
                        Some(sum) if is_added => sum.plus(&term),
                        Some(sum) => sum.minus(&term),
                        None if is_added => term,
                        None => T::ZERO.minus(&term),
                    });
                }
                is_added = !is_added;
            }
            minors[set] = sum.unwrap_or(T::ZERO);
        }
    }
    minors
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::linear::{cross, sum_of_products};
    use proptest::prelude::*;

    #[test]
    fn determinants_by_hand() {
        assert_eq!(determinant::<f64, [f64; 0]>(&[]), 1.0);
        assert_eq!(determinant(&[[2.0, 1.0], [1.0, -1.0]]), -3.0);
        assert_eq!(determinant(&[[0.0, 0.0, 2.0], [3.0, 0.0, 7.0], [1.0, 5.0, 9.0]]), 30.0);
        assert_eq!(hyperplane_normal::<f64, [f64; 1]>(&[]), [1.0]);
        assert_eq!(hyperplane_normal(&[[3.0, 4.0]]), [4.0, -3.0]);
    }

    properties! {
        #[test]
        fn a_normal_is_orthogonal_to_its_rows(
            rows in proptest::array::uniform3(proptest::array::uniform4(-3i32..4)),
            v in proptest::array::uniform4(-3i32..4),
        ) {
            let exact = |v: [i32; 4]| v.map(|c| Dyadic::from_f64(f64::from(c)));
            let (rows, v) = (rows.map(exact), exact(v));
            let normal = hyperplane_normal(&rows);
            for row in &rows {
                prop_assert!(sum_of_products(&normal, row).is_zero());
            }
            let [a, b, c] = rows;
            prop_assert_eq!(sum_of_products(&normal, &v), determinant(&[v, a, b, c]));
        }

        #[test]
        fn in_space_it_is_the_cross_product(
            a in proptest::array::uniform3(-1.0..1.0f64),
            b in proptest::array::uniform3(-1.0..1.0f64),
        ) {
            prop_assert_eq!(hyperplane_normal(&[a, b]), cross(&a, &b));
        }
    }
}
