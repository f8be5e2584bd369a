//! The front door: the volume that a zonotope sweeps.

use super::{Method, Sweep, SweepError, by_control_points};
use crate::motion::Motion;
use crate::zonotope::Zonotope;

impl Zonotope<3> {
    /// A zonotope around every placement of the body during a motion: of a rotation at constant rate by Theorem 6.1, of
    /// a rational motion by its control points. O(n log n) and O(k n) for k parts.
    ///
    /// ```
    /// use zonotope::Zonotope;
    /// use zonotope::motion::Motion;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
    /// let turn = Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], 0.5, [3.0, 0.0, 0.0])?;
    /// assert!(cube.swept(&turn)?.contains([3.0, 1.2, 1.0])?);
    /// # Ok(()) }
    /// ```
    ///
    /// # Errors
    /// [`SweepError::OutOfRange`] if the volume leaves the range of doubles.
    pub fn swept(&self, motion: &Motion) -> Result<Self, SweepError> {
        match motion.as_sweep() {
            Some(sweep) => self.swept_by(&sweep, Method::default()),
            None => by_control_points::volume(motion, self),
        }
    }

    /// A zonotope around every placement of a sweep, by a method.
    ///
    /// # Errors
    /// [`SweepError::OutOfRange`] if the volume leaves the range of doubles.
    pub fn swept_by(&self, sweep: &Sweep, method: Method) -> Result<Self, SweepError> {
        method.volume(sweep, self)
    }
}
