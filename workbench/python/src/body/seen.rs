//! Corners, faces and measures of a body.

use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;
use zonotope::Zonotope;
use zonotope::zonotope::combinatorics;

use super::{Any, Body, of_any, rows_of};
use crate::border::{error, outside};
use crate::faces::{self, Drawn};

/// The most vertices that a body of space may have for its faces to be listed. A process that asks for more memory than
/// there is ends without an exception.
const VERTEX_LIMIT: u64 = 1 << 24;

/// Vertices of shape (m, d), the facets as indices of vertices one after the other, and where each facet begins.
type Parts<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<u32>>, Bound<'py, PyArray1<u32>>);

#[pymethods]
impl Body {
    /// The corners of the smallest box around the body.
    fn bounding_box<'py>(&self, py: Python<'py>) -> PyResult<[Bound<'py, PyArray1<f64>>; 2]> {
        of_any!(&self.0, body => {
            let bounds = outside(py, || body.bounding_box())?;
            Ok([bounds.low, bounds.high].map(|corner| PyArray1::from_slice(py, &corner)))
        })
    }

    /// Length, area or volume as numerator and denominator in decimal.
    fn exact_volume(&self, py: Python<'_>) -> PyResult<(String, String)> {
        let measure = of_any!(&self.0, body => outside(py, || combinatorics(body).measure)?);
        Ok((measure.numerator().to_string(), measure.denominator().to_string()))
    }

    /// Vertices and facets of a body of the plane or of space.
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Parts<'py>> {
        match &self.0 {
            Any::One(body) => parts(py, outside(py, || faces::of_segment(body))?),
            Any::Two(body) => parts(py, outside(py, || faces::of_zonogon(body))?),
            Any::Three(body) if outside(py, || vertices_beyond(body, VERTEX_LIMIT))? => {
                let count = body.generators().len();
                let message = format!("the body of {count} generators has more than {VERTEX_LIMIT} vertices");
                Err(error(py, "too_large", &message))
            }
            Any::Three(body) => match outside(py, || faces::in_space(body))? {
                Ok(drawn) => parts(py, drawn),
                Err(reason) => Err(error(py, "too_large", &reason.to_string())),
            },
            other => {
                let message = format!(
                    "vertices and faces are listed in one to three dimensions, the body has {}",
                    other.dimension()
                );
                Err(error(py, "dimension_mismatch", &message))
            }
        }
    }
}

/// Whether a body has more vertices. They are counted, which takes much less than to list them, only where so many
/// generators in general position would have more: those of a plane or of few directions have few vertices.
fn vertices_beyond(body: &Zonotope<3>, limit: u64) -> bool {
    let n = body.generators().len() as u64;
    n.saturating_mul(n.saturating_sub(1)).saturating_add(2) > limit && combinatorics(body).vertices > limit
}

fn parts<const D: usize>(py: Python<'_>, drawn: Drawn<D>) -> PyResult<Parts<'_>> {
    Ok((rows_of(py, &drawn.vertices)?, drawn.corners.into_pyarray(py), drawn.starts.into_pyarray(py)))
}
