//! Conversions: generators as rows of numbers and, with the feature `nalgebra`, as the columns of a d × n matrix. All
//! exact.

use super::{Zonotope, ZonotopeError};

impl<const D: usize> Zonotope<D> {
    /// A zonotope from its centre and the coordinates of its generators, one generator after the other. O(n).
    ///
    /// # Errors
    /// [`ZonotopeError::RaggedRows`] if their number is not a multiple of D; else as [`Zonotope::new`].
    pub fn from_rows(center: [f64; D], coordinates: &[f64]) -> Result<Self, ZonotopeError> {
        let (rows, rest) = coordinates.as_chunks::<D>();
        if !rest.is_empty() {
            return Err(ZonotopeError::RaggedRows { length: coordinates.len(), dimension: D });
        }
        Self::new(center, rows.to_vec())
    }

    /// The coordinates of the generators, one generator after the other.
    pub fn rows(&self) -> &[f64] {
        self.generators().as_flattened()
    }
}

#[cfg(feature = "nalgebra")]
mod with_nalgebra {
    use nalgebra::{Const, Dyn, Matrix, OMatrix, RawStorage, SVector};

    use crate::zonotope::{Zonotope, ZonotopeError};

    impl<const D: usize> Zonotope<D> {
        /// A zonotope from its centre and a d × n matrix with its generators as columns. O(n).
        ///
        /// # Errors
        /// As [`Zonotope::new`].
        pub fn from_matrix<S: RawStorage<f64, Const<D>, Dyn>>(
            center: &SVector<f64, D>,
            generators: &Matrix<f64, Const<D>, Dyn, S>,
        ) -> Result<Self, ZonotopeError> {
            let columns = generators.column_iter().map(|column| std::array::from_fn(|k| column[k])).collect();
            Self::new((*center).into(), columns)
        }

        /// The centre as a vector.
        pub fn center_vector(&self) -> SVector<f64, D> {
            self.center().into()
        }

        /// The generators as the columns of a d × n matrix.
        pub fn generator_matrix(&self) -> OMatrix<f64, Const<D>, Dyn> {
            OMatrix::<f64, Const<D>, Dyn>::from_column_slice(self.rows())
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn matrices_hold_generators_as_columns() {
            let body = Zonotope::new([1.0, 2.0], vec![[3.0, 4.0], [5.0, 6.0], [7.0, 8.0]]).expect("finite");
            let matrix = body.generator_matrix();
            assert_eq!((matrix.nrows(), matrix.ncols(), matrix[(1, 2)]), (2, 3, 8.0));
            assert_eq!(Zonotope::from_matrix(&body.center_vector(), &matrix), Ok(body));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_go_round_and_ragged_ones_are_refused() {
        let body = Zonotope::from_rows([0.0; 2], &[1.0, 2.0, 3.0, 4.0]).expect("two rows of two");
        assert_eq!(body.generators(), [[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(Zonotope::from_rows([0.0; 2], body.rows()), Ok(body));
        assert_eq!(
            Zonotope::from_rows([0.0; 2], &[1.0; 3]),
            Err(ZonotopeError::RaggedRows { length: 3, dimension: 2 })
        );
        assert!(Zonotope::from_rows([0.0; 1], &[f64::NAN]).is_err());
    }
}
