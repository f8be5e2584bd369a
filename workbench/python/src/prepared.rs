//! A body of space that is asked again and again.

use pyo3::prelude::*;
use zonotope::collision::prepared::QueryStructure;
use zonotope::collision::prepared::choice::Kind;

use crate::body::{Any, Body, answered, sign};
use crate::border::{error, outside};

/// The structure that answers so many questions about a body in the least time.
#[pyclass(frozen, module = "zonotope._zonotope")]
pub(crate) struct Prepared(QueryStructure);

#[pymethods]
impl Prepared {
    /// The structure for about so many questions that holds at most so many bytes.
    #[new]
    fn new(py: Python<'_>, body: &Body, expected: u64, bytes: u64) -> PyResult<Self> {
        let Any::Three(body) = &body.0 else {
            let message = format!("bodies of space are prepared, this one has {} coordinates", body.0.dimension());
            return Err(error(py, "dimension_mismatch", &message));
        };
        let structure = outside(py, || QueryStructure::new(body.clone(), bytes, expected))?;
        structure.map(Self).map_err(|reason| error(py, "too_large", &reason.to_string()))
    }

    fn structure(&self) -> &'static str {
        match self.0.which() {
            Kind::Rows => "rows",
            Kind::Blocks => "blocks",
            Kind::DirectionTree => "direction tree",
            Kind::Cutting { .. } => "cutting",
            Kind::Facets => "facets",
            _ => "another structure",
        }
    }

    fn bytes(&self) -> u64 {
        self.0.bytes()
    }

    fn contains<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        answered(points, "points", self.readings(), |point| self.0.contains(point))
    }

    fn locate<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        answered(points, "points", self.readings(), |point| self.0.status(point).map(sign))
    }

    fn gauge<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        answered(points, "points", self.readings(), |point| self.0.gauge(point).map(|(value, _)| value))
    }
}

impl Prepared {
    /// Generators that a question reads, about: the square root of those that the structure's bytes can hold.
    fn readings(&self) -> usize {
        (self.0.bytes() / 24).isqrt() as usize
    }
}
