//! Pictures of bodies, drawn by the crate of the figures.

use figures::portrait;
use pyo3::prelude::*;
use zonotope::{Pose, Zonotope};

use crate::arrays::{Vectors, vectors};
use crate::body::{Any, Body, pose_of};
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

/// The SVG of a body with points of shape (m, d).
#[pyfunction]
pub(crate) fn svg_around(
    py: Python<'_>,
    body: &Body,
    points: &Bound<'_, PyAny>,
    title: &str,
    note: &str,
) -> PyResult<Option<String>> {
    match &body.0 {
        Any::Two(body) => {
            let points = many(vectors(points, "points")?);
            outside(py, || portrait::group::in_plane(title, note, std::slice::from_ref(body), &points))
        }
        Any::Three(body) => {
            let points = many(vectors(points, "points")?);
            outside(py, || portrait::group::in_space(title, note, std::slice::from_ref(body), &points))
        }
        _ => Ok(None),
    }
}

/// The SVG of two bodies of one dimension, those of space under poses of 12 numbers, matrix and translation, if given.
#[pyfunction]
pub(crate) fn svg_pair(
    py: Python<'_>,
    bodies: [PyRef<'_, Body>; 2],
    poses: [Option<[f64; 12]>; 2],
    title: &str,
    note: &str,
) -> PyResult<Option<String>> {
    match bodies.each_ref().map(|body| &body.0) {
        [Any::Two(a), Any::Two(b)] => {
            let pair = [a.clone(), b.clone()];
            outside(py, || portrait::group::in_plane(title, note, &pair, &[]))
        }
        [Any::Three(a), Any::Three(b)] => {
            let poses = poses.map(|pose| pose.map_or(Ok(Pose::IDENTITY), |numbers| pose_of(py, &numbers)));
            let [first, second] = poses;
            let pair = [placed(a, &first?), placed(b, &second?)];
            let [Some(a), Some(b)] = pair else { return Ok(None) };
            outside(py, || portrait::group::in_space(title, note, &[a, b], &[]))
        }
        _ => Ok(None),
    }
}

fn many<const D: usize>(vectors: Vectors<D>) -> Vec<[f64; D]> {
    match vectors {
        Vectors::One(vector) => vec![vector],
        Vectors::Many(vectors) => vectors,
    }
}

/// The body under a pose, rounded as drawings are; none beyond the range of doubles.
fn placed(body: &Zonotope<3>, pose: &Pose) -> Option<Zonotope<3>> {
    let turned = |v: [f64; 3]| pose.matrix().map(|row| row.iter().zip(v).map(|(entry, c)| entry * c).sum::<f64>());
    let (center, moved) = (turned(body.center()), pose.translation());
    let center = std::array::from_fn(|i| center[i] + moved[i]);
    Zonotope::new(center, body.generators().iter().map(|&generator| turned(generator)).collect()).ok()
}
