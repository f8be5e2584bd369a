//! A body of the library, whatever its dimension, and what it is asked.

mod algebra;
mod asked;
mod seen;
mod tracked;

pub(crate) use asked::{answered, pose_of, sign};

use numpy::{PyArray1, PyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use zonotope::{Zonotope, ZonotopeError};

use crate::arrays::{doubles, shape};
use crate::border::error;

/// A zonotope of one to six dimensions.
#[derive(Debug, Clone)]
pub(crate) enum Any {
    One(Zonotope<1>),
    Two(Zonotope<2>),
    Three(Zonotope<3>),
    Four(Zonotope<4>),
    Five(Zonotope<5>),
    Six(Zonotope<6>),
}

/// Evaluates an expression about the body, whose type has the dimension.
macro_rules! of_any {
    ($any:expr, $body:ident => $value:expr) => {
        match $any {
            $crate::body::Any::One($body) => $value,
            $crate::body::Any::Two($body) => $value,
            $crate::body::Any::Three($body) => $value,
            $crate::body::Any::Four($body) => $value,
            $crate::body::Any::Five($body) => $value,
            $crate::body::Any::Six($body) => $value,
        }
    };
}
pub(crate) use of_any;

/// Evaluates an expression about two bodies of one dimension; an error that names both dimensions otherwise.
macro_rules! of_two {
    ($py:expr, $a:expr, $b:expr, ($first:ident, $second:ident) => $value:expr) => {{
        use $crate::body::Any::{Five, Four, One, Six, Three, Two};
        match ($a, $b) {
            (One($first), One($second)) => Ok($value),
            (Two($first), Two($second)) => Ok($value),
            (Three($first), Three($second)) => Ok($value),
            (Four($first), Four($second)) => Ok($value),
            (Five($first), Five($second)) => Ok($value),
            (Six($first), Six($second)) => Ok($value),
            (a, b) => {
                let message = format!("the bodies have {} and {} coordinates", a.dimension(), b.dimension());
                Err($crate::border::error($py, "dimension_mismatch", &message))
            }
        }
    }};
}
pub(crate) use of_two;

impl Any {
    pub(crate) fn dimension(&self) -> usize {
        match self {
            Self::One(_) => 1,
            Self::Two(_) => 2,
            Self::Three(_) => 3,
            Self::Four(_) => 4,
            Self::Five(_) => 5,
            Self::Six(_) => 6,
        }
    }

    fn new(center: &[f64], coordinates: &[f64]) -> Result<Self, ZonotopeError> {
        fn of<const D: usize>(center: &[f64], coordinates: &[f64]) -> Result<Zonotope<D>, ZonotopeError> {
            Zonotope::from_rows(std::array::from_fn(|i| center[i]), coordinates)
        }
        Ok(match center.len() {
            1 => Self::One(of(center, coordinates)?),
            2 => Self::Two(of(center, coordinates)?),
            3 => Self::Three(of(center, coordinates)?),
            4 => Self::Four(of(center, coordinates)?),
            5 => Self::Five(of(center, coordinates)?),
            6 => Self::Six(of(center, coordinates)?),
            _ => unreachable!("the caller has looked at the number of coordinates"),
        })
    }
}

/// A zonotope { c + Σ δ_i g_i : |δ_i| ≤ 1 } of one to six dimensions.
#[pyclass(frozen, module = "zonotope._zonotope")]
#[derive(Debug)]
pub(crate) struct Body(pub(crate) Any);

#[pymethods]
impl Body {
    /// A centre of shape (d,) and generators of shape (n, d), one a row.
    #[new]
    fn new(center: &Bound<'_, PyAny>, rows: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = center.py();
        let (center, rows) = (doubles(center, "center")?, doubles(rows, "generators")?);
        let refused = |code, message: String| Err(error(py, code, &message));
        let [dimension] = *center.shape() else {
            return refused("dimension_mismatch", format!("center has shape {}, not (d,)", shape(center.shape())));
        };
        if !(1..=batch::MAX_DIMENSION).contains(&dimension) {
            let most = batch::MAX_DIMENSION;
            return refused("dimension_mismatch", format!("center has {dimension} coordinates; 1 to {most} are taken"));
        }
        match *rows.shape() {
            [_, d] if d == dimension => {}
            _ => {
                let [center, rows] = [center.shape(), rows.shape()].map(shape);
                let message = format!("center has shape {center} and the rows of generators {rows}");
                return refused("dimension_mismatch", message);
            }
        }
        match Any::new(center.as_slice()?, rows.as_slice()?) {
            Ok(any) => Ok(Self(any)),
            Err(reason) => refused("non_finite", reason.to_string()),
        }
    }

    fn dimension(&self) -> usize {
        self.0.dimension()
    }

    fn __len__(&self) -> usize {
        of_any!(&self.0, body => body.generators().len())
    }

    fn center<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        of_any!(&self.0, body => PyArray1::from_slice(py, &body.center()))
    }

    /// The generators, one a row.
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        of_any!(&self.0, body => rows_of(py, body.generators()))
    }

    /// The body as the batch has it.
    fn json(&self) -> String {
        of_any!(&self.0, body => {
            let rows: Vec<String> = body.generators().iter().map(|row| numbers(row)).collect();
            format!(r#"{{"center":{},"generators":[{}]}}"#, numbers(&body.center()), rows.join(","))
        })
    }
}

/// An array of shape (m, D).
pub(crate) fn rows_of<'py, const D: usize>(py: Python<'py>, rows: &[[f64; D]]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    use numpy::PyArrayMethods;
    PyArray1::from_slice(py, rows.as_flattened()).reshape([rows.len(), D])
}

/// Numbers as JSON, in the shortest form that reads back as the same doubles.
fn numbers(vector: &[f64]) -> String {
    let texts: Vec<String> = vector.iter().map(|number| format!("{number:?}")).collect();
    format!("[{}]", texts.join(","))
}
