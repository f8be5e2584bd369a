//! A stretch of a motion between two times, in whole numbers.

use dashu_int::IBig;

use super::quaternion::{Quaternion, Vector};

/// A stretch of a motion: the placements x ↦ (P(s) + R(q(s)) (W x + arm)) / W for s in [0, 1], P and q linear, that are
/// off the motion by at most an angle about its axis.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    /// The quaternion at both ends, or one that stays.
    pub(super) turns: Vec<Quaternion>,
    /// P at both ends.
    pub(super) base: [Vector; 2],
    pub(super) arm: Vector,
    /// W.
    pub(super) weight: IBig,
    /// The bound of the angle, in units of 2^-96.
    pub(super) angle_off: IBig,
}
