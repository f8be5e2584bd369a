//! Sums and images of bodies.

use numpy::PyUntypedArrayMethods;
use pyo3::prelude::*;
use zonotope::{Zonotope, ZonotopeError};

use super::{Any, Body, of_any, of_two};
use crate::arrays::{doubles, shape, vector};
use crate::border::{error, outside};

#[pymethods]
impl Body {
    /// The Minkowski sum.
    fn sum(&self, py: Python<'_>, other: &Self) -> PyResult<Self> {
        of_two!(py, &self.0, &other.0, (a, b) => made(py, outside(py, || a.minkowski_sum(b))?))?
    }

    /// The body moved by a vector of shape (d,).
    fn translated(&self, py: Python<'_>, by: &Bound<'_, PyAny>) -> PyResult<Self> {
        of_any!(&self.0, body => made(py, body.translated(vector(by, "the translation")?)))
    }

    /// The reflection in the origin.
    fn reflected(&self) -> Self {
        match &self.0 {
            Any::One(body) => Self(body.reflected().into()),
            Any::Two(body) => Self(body.reflected().into()),
            Any::Three(body) => Self(body.reflected().into()),
            Any::Four(body) => Self(body.reflected().into()),
            Any::Five(body) => Self(body.reflected().into()),
            Any::Six(body) => Self(body.reflected().into()),
        }
    }

    /// The image under a matrix of shape (e, d).
    fn image(&self, py: Python<'_>, matrix: &Bound<'_, PyAny>) -> PyResult<Self> {
        let array = doubles(matrix, "the matrix")?;
        let (d, rows) = (self.0.dimension(), array.as_slice()?);
        match *array.shape() {
            [e, columns] if columns == d && (1..=batch::MAX_DIMENSION).contains(&e) => match e {
                1 => of_any!(&self.0, body => image::<_, 1>(py, body, rows)),
                2 => of_any!(&self.0, body => image::<_, 2>(py, body, rows)),
                3 => of_any!(&self.0, body => image::<_, 3>(py, body, rows)),
                4 => of_any!(&self.0, body => image::<_, 4>(py, body, rows)),
                5 => of_any!(&self.0, body => image::<_, 5>(py, body, rows)),
                _ => of_any!(&self.0, body => image::<_, 6>(py, body, rows)),
            },
            _ => {
                let (given, most) = (shape(array.shape()), batch::MAX_DIMENSION);
                let message = format!("the matrix has shape {given}, not (e, {d}) with e from 1 to {most}");
                Err(error(py, "dimension_mismatch", &message))
            }
        }
    }
}

fn image<const D: usize, const E: usize>(py: Python<'_>, body: &Zonotope<D>, rows: &[f64]) -> PyResult<Body>
where
    Any: From<Zonotope<E>>,
{
    let matrix: [[f64; D]; E] = std::array::from_fn(|i| std::array::from_fn(|j| rows[D * i + j]));
    made(py, outside(py, || body.linear_image(&matrix))?)
}

fn made<const D: usize>(py: Python<'_>, body: Result<Zonotope<D>, ZonotopeError>) -> PyResult<Body>
where
    Any: From<Zonotope<D>>,
{
    body.map(|body| Body(body.into())).map_err(|reason| error(py, "non_finite", &reason.to_string()))
}

/// The body of a dimension among those of any.
macro_rules! from_dimension {
    ($($dimension:literal => $variant:ident),*) => {
        $(impl From<Zonotope<$dimension>> for Any {
            fn from(body: Zonotope<$dimension>) -> Self {
                Self::$variant(body)
            }
        })*
    };
}
from_dimension!(1 => One, 2 => Two, 3 => Three, 4 => Four, 5 => Five, 6 => Six);
