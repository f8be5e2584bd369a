//! Two bodies of space in a sequence of frames.

use numpy::{IntoPyArray, PyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;
use zonotope::Pose;
use zonotope::collision::tracking::WarmTracker;

use super::asked::sign;
use super::{Any, Body};
use crate::arrays::{doubles, shape};
use crate::border::{error, outside};

#[pymethods]
impl Body {
    /// The way in which two bodies meet in each frame, under poses of shape (m, 4, 4).
    fn track<'py>(
        &self,
        py: Python<'py>,
        other: &Self,
        poses: &Bound<'py, PyAny>,
        other_poses: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<i8>>> {
        let (Any::Three(a), Any::Three(b)) = (&self.0, &other.0) else {
            return Err(error(py, "dimension_mismatch", "only bodies of space are placed by poses"));
        };
        let [first, second] = [read(poses, "poses_a")?, read(other_poses, "poses_b")?];
        if first.len() != second.len() {
            let message = format!("{} poses of the first body and {} of the second", first.len(), second.len());
            return Err(error(py, "length_mismatch", &message));
        }
        let frames = outside(py, || {
            let mut tracker = WarmTracker::new(a, b);
            let frame = |(first, second)| sign(tracker.frame(first, second, &mut ()).status());
            first.iter().zip(&second).map(frame).collect::<Vec<i8>>()
        })?;
        Ok(frames.into_pyarray(py))
    }
}

fn read(given: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<Pose>> {
    let (py, array) = (given.py(), doubles(given, name)?);
    let [_, 4, 4] = *array.shape() else {
        let message = format!("{name} has shape {}, not (m, 4, 4)", shape(array.shape()));
        return Err(error(py, "dimension_mismatch", &message));
    };
    let pose = |(frame, rows): (usize, &[f64; 16])| {
        if rows[12..] != [0.0, 0.0, 0.0, 1.0] {
            let message = format!("{name}, frame {frame}: the last row of the matrix is not 0, 0, 0, 1");
            return Err(error(py, "bad_input", &message));
        }
        let matrix = std::array::from_fn(|i| std::array::from_fn(|j| rows[4 * i + j]));
        let made = Pose::new(matrix, std::array::from_fn(|i| rows[4 * i + 3]));
        made.map_err(|reason| error(py, "non_finite", &format!("{name}, frame {frame}: {reason}")))
    };
    array.as_slice()?.as_chunks().0.iter().enumerate().map(pose).collect()
}
