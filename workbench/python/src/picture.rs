//! Pictures of bodies, drawn by the crate of the figures.

use figures::portrait;
use pyo3::prelude::*;

use crate::body::{Any, Body};
use crate::border::outside;

/// The SVG of a body of the plane or of space; none where there is nothing to see, or too much.
#[pyfunction]
pub(crate) fn svg(py: Python<'_>, body: &Body) -> PyResult<Option<String>> {
    match &body.0 {
        Any::Two(body) => outside(py, || portrait::of_zonogon(body)),
        Any::Three(body) => outside(py, || portrait::of_solid(body)),
        _ => Ok(None),
    }
}
