//! The distance of a rotation at constant rate from the stretch that encloses it, along a direction.
//!
//! A turn by an angle that is off moves a point across the axis, by at most that angle times its distance from the
//! axis. Along a direction u it moves by at most |u × a| of that, a the unit vector of the axis: nothing along the
//! axis. A direction that turns with a body keeps its angle to the body's own axis.

use super::super::SeparatingDirection;
use crate::numeric::linear::{cross, sum_norm};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, MARGIN_AXIS_ROUNDING, MODERATE_SIZES};

/// A bound of how far points of a body are from their places on a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::motion::continuous) struct Margin {
    /// The largest distance of a point of the body from its place.
    pub(in crate::motion::continuous) distance: f64,
    /// The unit vector of the axis, rounded: points are off across it.
    pub(in crate::motion::continuous) axis: [f64; 3],
}

impl Margin {
    /// The margin of a body that is where the stretch puts it.
    pub(in crate::motion::continuous) const NONE: Self = Self { distance: 0.0, axis: [0.0; 3] };

    /// Whether it is a bound: angles and reaches of any size may leave the range of doubles.
    pub(in crate::motion::continuous) fn is_finite(&self) -> bool {
        self.distance.is_finite() && self.axis.iter().all(|c| c.is_finite())
    }

    /// The bound along a direction that keeps its angle to the axis, times the direction's length.
    fn along(&self, u: &[f64; 3]) -> f64 {
        // the sum of the magnitudes of the coordinates is at least the length
        self.distance * (sum_norm(&cross(u, &self.axis)) + MARGIN_AXIS_ROUNDING * sum_norm(u))
    }

    /// The bound along a direction that may turn beside the axis.
    fn along_any(&self, length: f64) -> f64 {
        self.distance * length
    }
}

/// The margin of a gap: a rotation at constant rate may leave the gap of two bodies along a direction smaller than that
/// of the stretch, but by no more than this. It is infinite where products with the direction may vanish.
pub(in crate::motion::continuous) fn along(margins: &[Margin; 2], direction: &SeparatingDirection) -> f64 {
    let [first, second] = margins;
    if (first.distance, second.distance) == (0.0, 0.0) {
        return 0.0;
    }
    if !MODERATE_SIZES.contains(&direction.length_at_most()) {
        return f64::INFINITY;
    }
    let bound = match direction {
        SeparatingDirection::Space(u) => first.along(u) + second.along(u),
        SeparatingDirection::First(u) => first.along(u) + second.along_any(sum_norm(u)),
        SeparatingDirection::Second(u) => first.along_any(sum_norm(u)) + second.along(u),
        SeparatingDirection::Edges(_) => {
            let length = direction.length_at_most();
            first.along_any(length) + second.along_any(length)
        }
    };
    (bound * FIVE_ROUNDINGS * FIVE_ROUNDINGS).next_up()
}
