//! Two bodies of space that are followed from frame to frame.

use std::sync::{Mutex, MutexGuard, PoisonError};

use pyo3::prelude::*;
use self_cell::self_cell;
use zonotope::Zonotope;
use zonotope::collision::tracking::WarmTracker;

use crate::body::{Any, Body, pose_of, sign};
use crate::border::{error, inside};

type Pair = [Zonotope<3>; 2];

self_cell!(
    /// The bodies, and the library's tracker, which borrows them.
    struct Following {
        owner: Box<Pair>,
        #[covariant]
        dependent: WarmTracker,
    }
);

/// A tracker that owns its bodies. Frames come one after the other, from whatever threads.
#[pyclass(frozen, module = "zonotope._zonotope")]
pub(crate) struct Tracker(Mutex<Following>);

#[pymethods]
impl Tracker {
    /// A tracker of two bodies of space.
    #[new]
    fn new(py: Python<'_>, a: &Body, b: &Body) -> PyResult<Self> {
        let (Any::Three(a), Any::Three(b)) = (&a.0, &b.0) else {
            let message = "only bodies of space are placed by poses";
            return Err(error(py, "dimension_mismatch", message));
        };
        let pair = Box::new([a.clone(), b.clone()]);
        inside(py, || Self(Mutex::new(Following::new(pair, |pair| WarmTracker::new(&pair[0], &pair[1])))))
    }

    /// The way in which the bodies meet under poses of 12 numbers, matrix and translation.
    fn frame(&self, py: Python<'_>, pose_a: [f64; 12], pose_b: [f64; 12]) -> PyResult<i8> {
        let (first, second) = (pose_of(py, &pose_a)?, pose_of(py, &pose_b)?);
        inside(py, || {
            let mut following = self.following();
            following.with_dependent_mut(|_, tracker| sign(tracker.frame(&first, &second, &mut ()).status()))
        })
    }
}

impl Tracker {
    /// The state. A frame that panicked has left no answer behind: what is carried over decides nothing.
    fn following(&self) -> MutexGuard<'_, Following> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
