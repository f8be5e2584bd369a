//! Questions about one point or direction, or about many.

use numpy::{IntoPyArray, PyArray1};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use zonotope::{Pose, Status, Zonotope};

use super::{Any, Body, of_any, of_two, rows_of};
use crate::arrays::{Vectors, vectors};
use crate::border::{error, inside, outside};
use crate::many::each;

/// The sign of a place: −1 inside, 0 on the boundary, 1 outside.
pub(crate) fn sign(status: Status) -> i8 {
    match status {
        Status::Inside => -1,
        Status::Boundary => 0,
        Status::Outside => 1,
    }
}

/// The answer about one point as a scalar, those about many as an array.
pub(crate) fn answered<'py, const D: usize, T, E>(
    given: &Bound<'py, PyAny>,
    name: &str,
    readings: usize,
    ask: impl Fn([f64; D]) -> Result<T, E> + Sync + Send,
) -> PyResult<Bound<'py, PyAny>>
where
    T: numpy::Element + Send + IntoPyObjectExt<'py>,
    E: std::fmt::Display + Send,
{
    let py = given.py();
    match vectors::<D>(given, name)? {
        Vectors::One(vector) => {
            let answer = inside(py, || ask(vector))?.map_err(|reason| refused(py, name, None, &vector, &reason))?;
            answer.into_bound_py_any(py)
        }
        Vectors::Many(vectors) => {
            let answers = outside(py, || each(&vectors, readings, ask))?;
            let answers = answers.map_err(|(row, reason)| refused(py, name, Some(row), &vectors[row], &reason))?;
            Ok(answers.into_pyarray(py).into_any())
        }
    }
}

/// The exception for a vector that has no answer. It names the number that is not finite as NumPy would.
fn refused(py: Python<'_>, name: &str, row: Option<usize>, vector: &[f64], reason: &impl std::fmt::Display) -> PyErr {
    let coordinate = vector.iter().position(|c| !c.is_finite());
    let place: Vec<String> = row.into_iter().chain(coordinate).map(|index| index.to_string()).collect();
    let place = if place.is_empty() { name.to_owned() } else { format!("{name}[{}]", place.join(", ")) };
    let message = match coordinate {
        Some(i) => format!("{place} is {}, not a finite number", vector[i]),
        None => format!("{place}: {reason}"),
    };
    error(py, "non_finite", &message)
}

#[pymethods]
impl Body {
    fn contains<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        of_any!(&self.0, body => {
            answered(points, "points", body.generators().len(), |point| body.contains(point))
        })
    }

    fn locate<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        of_any!(&self.0, body => {
            let place = |point| body.locate(point).map(|location| sign(location.status()));
            answered(points, "points", body.generators().len(), place)
        })
    }

    fn gauge<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        of_any!(&self.0, body => {
            let gauge = |point| body.gauge(point).map(|gauge| gauge.value);
            answered(points, "points", body.generators().len(), gauge)
        })
    }

    fn support<'py>(&self, directions: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        of_any!(&self.0, body => {
            let value = |direction| finite(direction).map(|direction| body.support(direction).value());
            answered(directions, "directions", body.generators().len(), value)
        })
    }

    fn extreme_points<'py>(&self, directions: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        of_any!(&self.0, body => extreme_points(body, directions))
    }

    /// The way in which two bodies meet, the second under a pose of 12 numbers, matrix and translation, if given.
    fn meets(&self, py: Python<'_>, other: &Self, pose: Option<[f64; 12]>) -> PyResult<i8> {
        if let Some(pose) = pose {
            let (a, b, pose) = placed(py, self, other, &pose)?;
            return outside(py, || sign(b.at(&pose).intersection(a).status()));
        }
        of_two!(py, &self.0, &other.0, (a, b) => outside(py, || sign(a.intersection(b).status())))?
    }

    /// The distance of two bodies in up to three dimensions, the second under a pose as in `meets`, if given.
    fn distance(&self, py: Python<'_>, other: &Self, pose: Option<[f64; 12]>) -> PyResult<f64> {
        if let Some(pose) = pose {
            let (a, b, pose) = placed(py, self, other, &pose)?;
            return outside(py, || b.at(&pose).distance(a));
        }
        match (&self.0, &other.0) {
            (Any::One(a), Any::One(b)) => outside(py, || a.distance(b)),
            (Any::Two(a), Any::Two(b)) => outside(py, || a.distance(b)),
            (Any::Three(a), Any::Three(b)) => outside(py, || a.distance(b)),
            (a, b) => {
                let [a, b] = [a, b].map(Any::dimension);
                let message = format!("the bodies have {a} and {b} coordinates; distances are those of 1 to 3");
                Err(error(py, "dimension_mismatch", &message))
            }
        }
    }
}

fn extreme_points<'py, const D: usize>(
    body: &Zonotope<D>,
    directions: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = directions.py();
    let extreme = |direction| finite(direction).map(|direction| body.support(direction).point());
    match vectors::<D>(directions, "directions")? {
        Vectors::One(direction) => match extreme(direction) {
            Ok(point) => Ok(PyArray1::from_slice(py, &point).into_any()),
            Err(reason) => Err(refused(py, "directions", None, &direction, &reason)),
        },
        Vectors::Many(directions) => {
            let points = outside(py, || each(&directions, body.generators().len(), extreme))?;
            let refused = |(row, reason)| refused(py, "directions", Some(row), &directions[row], &reason);
            Ok(rows_of(py, &points.map_err(refused)?)?.into_any())
        }
    }
}

/// The direction, if all its coordinates are finite.
fn finite<const D: usize>(direction: [f64; D]) -> Result<[f64; D], &'static str> {
    if direction.iter().all(|c| c.is_finite()) { Ok(direction) } else { Err("a direction is not finite") }
}

/// Two bodies of space, and the pose of the second.
fn placed<'a>(
    py: Python<'_>,
    first: &'a Body,
    second: &'a Body,
    pose: &[f64; 12],
) -> PyResult<(&'a Zonotope<3>, &'a Zonotope<3>, Pose)> {
    let (Any::Three(a), Any::Three(b)) = (&first.0, &second.0) else {
        return Err(error(py, "dimension_mismatch", "only bodies of space are placed by a pose"));
    };
    Ok((a, b, pose_of(py, pose)?))
}

/// The pose of 12 numbers, matrix by rows and translation.
pub(crate) fn pose_of(py: Python<'_>, numbers: &[f64; 12]) -> PyResult<Pose> {
    let matrix = std::array::from_fn(|i| std::array::from_fn(|j| numbers[3 * i + j]));
    let translation = std::array::from_fn(|i| numbers[9 + i]);
    Pose::new(matrix, translation).map_err(|reason| error(py, "non_finite", &reason.to_string()))
}
