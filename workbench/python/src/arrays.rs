//! Arrays of Python as vectors of the library.

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::PyTypeInfo;
use pyo3::prelude::*;

use crate::border::error;

/// One vector, or many in the rows of an array.
pub(crate) enum Vectors<const D: usize> {
    /// An array of shape (D,).
    One([f64; D]),
    /// An array of shape (m, D).
    Many(Vec<[f64; D]>),
}

/// The vectors of an array-like of shape (D,) or (m, D): any real dtype, any strides, nested lists. They are copied,
/// since other threads of Python may write into an array while the library reads.
pub(crate) fn vectors<const D: usize>(given: &Bound<'_, PyAny>, name: &str) -> PyResult<Vectors<D>> {
    if let Some(vector) = contiguous_vector::<D>(given) {
        return Ok(Vectors::One(vector));
    }
    let array = doubles(given, name)?;
    let numbers = array.as_slice()?;
    match *array.shape() {
        [d] if d == D => Ok(Vectors::One(std::array::from_fn(|i| numbers[i]))),
        [_, d] if d == D => Ok(Vectors::Many(numbers.as_chunks().0.to_vec())),
        _ => {
            let message = format!("{name} has shape {}, not ({D},) or (m, {D})", shape(array.shape()));
            Err(error(given.py(), "dimension_mismatch", &message))
        }
    }
}

/// The one vector of an array-like of shape (D,).
pub(crate) fn vector<const D: usize>(given: &Bound<'_, PyAny>, name: &str) -> PyResult<[f64; D]> {
    let array = doubles(given, name)?;
    if *array.shape() != [D] {
        let message = format!("{name} has shape {}, not ({D},)", shape(array.shape()));
        return Err(error(given.py(), "dimension_mismatch", &message));
    }
    let numbers = array.as_slice()?;
    Ok(std::array::from_fn(|i| numbers[i]))
}

/// The quick way of one question: an array of doubles that lie one after the other, and no subclass with a mask.
fn contiguous_vector<const D: usize>(given: &Bound<'_, PyAny>) -> Option<[f64; D]> {
    if !PyUntypedArray::is_exact_type_of(given) {
        return None;
    }
    let array = given.cast::<PyArray1<f64>>().ok()?.try_readonly().ok()?;
    array.as_slice().ok()?.try_into().ok()
}

/// An array-like as contiguous doubles.
pub(crate) fn doubles<'py>(given: &Bound<'py, PyAny>, name: &str) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let py = given.py();
    let array = py.import("zonotope._arrays")?.getattr("doubles")?.call1((given, name))?;
    Ok(array.cast::<PyArrayDyn<f64>>()?.try_readonly()?)
}

/// A shape as Python writes it.
pub(crate) fn shape(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        many => format!("({})", many.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}
