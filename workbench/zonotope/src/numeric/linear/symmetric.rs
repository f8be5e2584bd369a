//! Symmetric matrices of three rows and columns in doubles, and equations with one that may be singular.

use super::{cyclic_cross_products, dot};

/// The addition to the diagonal of a matrix, in terms of its trace, so that a singular one has an inverse as well.
const DIAGONAL_SHIFT: f64 = 4e-15;

/// With a determinant below this, in terms of the cube of the trace, a matrix may be singular.
const REGULAR_DETERMINANT: f64 = 4e-15;

/// A symmetric matrix by its entries xx, xy, xz, yy, yz, zz; none of its eigenvalues is negative.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SymmetricMatrix(pub(crate) [f64; 6]);

impl SymmetricMatrix {
    /// The sum of the diagonal.
    pub(crate) fn trace(&self) -> f64 {
        let [xx, _, _, yy, _, zz] = self.0;
        xx + yy + zz
    }

    /// The sum of two matrices.
    #[inline]
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self([0, 1, 2, 3, 4, 5].map(|i| self.0[i] + other.0[i]))
    }

    /// The matrix and a multiple of v vᵀ.
    pub(crate) fn plus_square(&self, factor: f64, [x, y, z]: &[f64; 3]) -> Self {
        let square = [x * x, x * y, x * z, y * y, y * z, z * z];
        Self([0, 1, 2, 3, 4, 5].map(|i| self.0[i] + factor * square[i]))
    }

    /// The x with matrix · x = r, if the matrix is certainly not singular.
    #[inline(always)]
    pub(crate) fn solve_regular(&self, r: &[f64; 3]) -> Option<[f64; 3]> {
        let [xx, xy, xz, yy, yz, zz] = self.0;
        let trace = xx + yy + zz;
        let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let minors = cyclic_cross_products(&rows[0], &rows[1], &rows[2]);
        let determinant = dot(&rows[0], &minors[0]);
        let inverse = 1.0 / determinant;
        let is_regular = determinant > REGULAR_DETERMINANT * trace * trace * trace;
        // written out: calls for each entry show in the time of a question about a box
        let [a, b, c] = &minors;
        is_regular.then(|| [dot(a, r) * inverse, dot(b, r) * inverse, dot(c, r) * inverse])
    }

    /// The x with matrix · x = r, or nearly where there is none, and whether the matrix is certainly not singular.
    pub(crate) fn solve(&self, r: &[f64; 3]) -> ([f64; 3], bool) {
        let [xx, xy, xz, yy, yz, zz] = self.0;
        let trace = xx + yy + zz;
        let more = DIAGONAL_SHIFT * trace;
        let rows = [[xx + more, xy, xz], [xy, yy + more, yz], [xz, yz, zz + more]];
        let minors = cyclic_cross_products(&rows[0], &rows[1], &rows[2]);
        let determinant = dot(&rows[0], &minors[0]);
        let inverse = 1.0 / determinant;
        let solve = |r: &[f64; 3]| minors.map(|row| dot(&row, r) * inverse);
        let first = solve(r);
        // what was added to the diagonal is taken back
        let second = solve(&first.map(|c| more * c));
        ([0, 1, 2].map(|k| first[k] + second[k]), determinant > REGULAR_DETERMINANT * trace * trace * trace)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_by_hand() {
        let matrix = SymmetricMatrix([2.0, 1.0, 0.0, 2.0, 0.0, 4.0]);
        assert_eq!(matrix.trace(), 8.0);
        let x = matrix.solve_regular(&[4.0, 5.0, 8.0]).expect("the determinant is 12");
        let (nearly, is_regular) = matrix.solve(&[4.0, 5.0, 8.0]);
        assert!(
            is_regular && x.iter().chain(&nearly).zip([1.0, 2.0, 2.0].repeat(2)).all(|(a, b)| (a - b).abs() < 1e-14)
        );
        // of the plane alone; with the square of its normal it is all of space
        let flat = SymmetricMatrix([1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        assert!(flat.solve_regular(&[1.0, 2.0, 0.0]).is_none() && !flat.solve(&[1.0, 2.0, 0.0]).1);
        assert_eq!(
            flat.plus_square(flat.trace(), &[0.0, 0.0, 1.0]).solve_regular(&[1.0, 2.0, 4.0]),
            Some([1.0, 2.0, 2.0])
        );
    }

    #[test]
    fn sums_and_squares_by_hand() {
        let matrix = SymmetricMatrix([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(
            matrix.plus(&SymmetricMatrix([10.0, 20.0, 30.0, 40.0, 50.0, 60.0])).0,
            [11.0, 22.0, 33.0, 44.0, 55.0, 66.0]
        );
        assert_eq!(matrix.plus_square(2.0, &[3.0, -5.0, 7.0]).0, [19.0, -28.0, 45.0, 54.0, -65.0, 104.0]);
    }

    /// The diagonal is 1, 1 and c: c is the determinant, which must exceed 3.2e-14, a part of the cube of the trace.
    /// An equation that may have no solution gets 8e-15 added to the diagonal.
    #[test]
    fn a_matrix_is_regular_if_its_determinant_exceeds_a_part_of_the_cube_of_its_trace() {
        for axis in [0, 3, 5] {
            let matrix = |c: f64| {
                let mut entries = [1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
                entries[axis] = c;
                SymmetricMatrix(entries)
            };
            let is_regular = |c: f64| matrix(c).solve_regular(&[1.0; 3]).is_some();
            assert_eq!([2.8e-14, 3.6e-14].map(is_regular), [false, true], "{axis}");
            let is_regular_when_shifted = |c: f64| matrix(c).solve(&[1.0; 3]).1;
            assert_eq!([2e-14, 2.8e-14].map(is_regular_when_shifted), [false, true], "{axis}");
        }
        let zero = SymmetricMatrix([0.0; 6]);
        assert!(zero.solve_regular(&[1.0; 3]).is_none() && !zero.solve(&[1.0; 3]).1);
    }
}
