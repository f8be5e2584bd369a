//! A rotation at constant rate, which rational placements are near: on an arc the quaternion goes linearly between two
//! rational ones, and a bound says how far the angle is off.
//!
//! An arc is exact where this rotation is all that moves, so that its placements alone count, and not the time of each:
//! about one axis it turns through every angle between its ends, and ends that are moved outwards by more than their
//! rounding contain those of the motion.
//!
//! Let θ be the angle of an arc, a = θ/4 and t = tan a. Seen from its middle, at the share (1 + x) / 2 of its time,
//! −1 ≤ x ≤ 1, a linear quaternion is at the angle atan(x t) and that of the motion at x a = x atan t, and rotations
//! are by twice these angles. For x ≥ 0 the difference of the angles is the integral over 0 ≤ τ ≤ t of x / (1 + x² τ²)
//! − x / (1 + τ²) ≤ x (1 − x²) τ², which is at most x (1 − x²) t³ / 3 ≤ 2 t³ / (9 √3); so the rotations differ by at
//! most 4 t³ / (9 √3). Both quaternions have one length there; those of rounded ones differ by 2^-51, which moves the
//! angle between them by less than the rounding of an end: a rounding is added for the ends, and one for that.

use super::arc::Arc;
use super::scalar::Scalar;
use super::sweep::Sweep;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, exact};
use crate::numeric::linear::{cross, euclidean_norm, norm_of_any_size, sum_norm};
use crate::numeric::scaling::scaled_exactly;
use crate::numeric::tolerance::{ANGLE_ROUNDING, ANGLE_ROUNDING_OF_A_TURN, CHORD_OF_A_LINEAR_QUATERNION, UNIT};
use crate::zonotope::Zonotope;

/// The largest angle of an arc: a quarter turn. tan(θ/4) is 0.415 there.
pub(super) const LARGEST_ANGLE: f64 = std::f64::consts::FRAC_PI_2;

/// A fourth of an angle of which the tangent is below 0.9; larger ones have no bound.
const LARGEST_FOURTH: f64 = 0.7;

/// Whether an arc must have each placement at its time. A question about two bodies in motion asks for `Untimed` where
/// one of them only turns and the other rests, every question about one time for `Timed`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Timing {
    /// Each placement is that of the motion at the same time, but for a bound.
    Timed,
    /// The placements of the motion are among those of the arc, each at any time.
    Untimed,
}

/// The motion x ↦ p + R(t · angle) (x − p) + t · translation for t in [0, 1], R about an axis of any length.
#[derive(Debug, Clone)]
pub(super) struct ConstantRate {
    axis_point: [f64; 3],
    given_axis: [f64; 3],
    /// The axis over a power of two, exactly.
    axis: ExactVector,
    /// The same in doubles.
    bounded_axis: [Bounded; 3],
    /// The length of that axis.
    length: f64,
    angle: f64,
    translation: [f64; 3],
}

impl ConstantRate {
    /// A motion of finite numbers about an axis that is not 0.
    pub(super) fn new(axis_point: [f64; 3], axis: [f64; 3], angle: f64, translation: [f64; 3]) -> Self {
        let given_axis = axis;
        let exponent = exact(axis).iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        let axis = exact(axis).map(|c| c.scaled(-exponent));
        let bounded_axis = axis.each_ref().map(Bounded::near);
        let length = euclidean_norm(&bounded_axis.map(|c| c.value));
        Self { axis_point, given_axis, axis, bounded_axis, length, angle, translation }
    }

    /// The same motion with all lengths times a power of two; `None` where they leave the range of doubles.
    pub(super) fn scaled(&self, exponent: i64) -> Option<Self> {
        let [axis_point, translation] = [&self.axis_point, &self.translation].map(|v| scaled_exactly(v, exponent));
        Some(Self { axis_point: axis_point?, translation: translation?, ..self.clone() })
    }

    /// The binary exponent of the largest length; `None` where all are zero.
    pub(super) fn size_exponent(&self) -> Option<i64> {
        let lengths = self.axis_point.iter().chain(&self.translation);
        lengths.filter_map(|c| Dyadic::from_f64(*c).binary_exponent()).max()
    }

    /// The angle in radians.
    pub(super) fn angle(&self) -> f64 {
        self.angle
    }

    /// The sweep of the motion: a turn by a negative angle is one about the opposite axis.
    pub(super) fn as_sweep(&self) -> Sweep {
        let sign = if self.angle < 0.0 { -1.0 } else { 1.0 };
        let axis = self.given_axis.map(|c| sign * c);
        Sweep::new(self.axis_point, axis, self.angle.abs(), self.translation)
            .unwrap_or_else(|_| unreachable!("the motion was checked"))
    }

    /// The unit vector of the axis, rounded.
    pub(super) fn unit_axis(&self) -> [f64; 3] {
        self.bounded_axis.map(|c| c.value / self.length)
    }

    /// Whether the axis stays where it is.
    pub(super) fn only_turns(&self) -> bool {
        self.translation == [0.0; 3]
    }

    /// The arc between two times, exactly; its quaternions are near those of the motion.
    pub(super) fn exact_arc(&self, times: [f64; 2], timing: Timing) -> Arc<Dyadic> {
        self.between(times, timing, &self.axis)
    }

    /// The same arc in doubles.
    pub(super) fn arc(&self, times: [f64; 2], timing: Timing) -> Arc<Bounded> {
        self.between(times, timing, &self.bounded_axis)
    }

    /// The same in doubles without bounds.
    pub(super) fn rounded_arc(&self, times: [f64; 2], timing: Timing) -> Arc<f64> {
        self.between(times, timing, &self.bounded_axis.map(|c| c.value))
    }

    /// A bound of the angle between a placement of the motion and that of the arc at the same time.
    pub(super) fn angle_off(&self, [from, to]: [f64; 2]) -> f64 {
        if self.angle == 0.0 {
            return 0.0;
        }
        let rounding = self.rounding();
        let fourth = (self.angle.abs() * (to - from) + 2.0 * rounding) / 4.0;
        if fourth.is_nan() || fourth >= LARGEST_FOURTH {
            return f64::INFINITY;
        }
        let tangent = libm::tan(fourth);
        CHORD_OF_A_LINEAR_QUATERNION * tangent * tangent * tangent + 2.0 * rounding
    }

    /// A bound above the distance of a body's points from the axis.
    pub(super) fn distance_from_axis(&self, body: &Zonotope<3>) -> f64 {
        let unit = self.unit_axis();
        let off_axis = |v: [f64; 3]| norm_of_any_size(&cross(&unit, &v));
        let center = [0, 1, 2].map(|k| body.center()[k] - self.axis_point[k]);
        let distance = body.generators().iter().fold(off_axis(center), |sum, g| sum + off_axis(*g));
        // a product with the unit vector is off by a few roundings of the whole length, or of the smallest doubles
        let size = body.generators().iter().fold(norm_of_any_size(&center), |sum, g| sum + norm_of_any_size(g));
        let terms = (body.generators().len() + 16) as f64;
        (distance + terms * 4.0 * (UNIT * size + f64::from_bits(1))).next_up()
    }

    /// A bound of the angle of the rotation by which an end of an arc is off.
    fn rounding(&self) -> f64 {
        ANGLE_ROUNDING + ANGLE_ROUNDING_OF_A_TURN * self.angle.abs()
    }

    /// The arc between two times that go up: with [`Timing::Untimed`] the first end is moved back and the last one on,
    /// by twice the bound of what rounds them, once for the end and once for the one that is moved.
    fn between<T: Scalar>(&self, times: [f64; 2], timing: Timing, axis: &[T; 3]) -> Arc<T> {
        let outwards = match timing {
            // `half` is half an angle: the angle moves by twice as much
            Timing::Untimed if self.angle != 0.0 => self.rounding().copysign(self.angle),
            // no turn is not rounded
            Timing::Untimed | Timing::Timed => 0.0,
        };
        let turned = |(t, outwards): (f64, f64)| {
            let half = self.angle * t / 2.0 + outwards;
            let along = T::of(libm::sin(half) / self.length);
            let [x, y, z] = axis.each_ref().map(|c| along.times(c));
            [T::of(libm::cos(half)), x, y, z]
        };
        let gone = |t: f64| {
            let moved = |k: usize| T::of(t).times(&T::of(self.translation[k]));
            [0, 1, 2].map(|k| T::of(self.axis_point[k]).plus(&moved(k)))
        };
        Arc {
            turns: [(times[0], -outwards), (times[1], outwards)].map(turned),
            base: times.map(gone),
            base_size: sum_norm(&self.axis_point) + sum_norm(&self.translation),
            arm: self.axis_point.map(|c| T::of(-c)),
            weight: T::ONE,
            is_translation: self.angle == 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_of_which_doubles_hold_no_turn_has_no_bound() {
        for angle in [1.3e16, 1.41e16, 5e16, 1e300] {
            let motion = ConstantRate::new([0.0; 3], [0.0, 0.0, 3.0], angle, [0.0; 3]);
            assert_eq!(motion.angle_off([0.5, 0.5]), f64::INFINITY, "{angle}");
        }
    }

    #[test]
    fn a_turn_by_no_angle_leaves_a_body_where_it_is() {
        for angle in [0.0, -0.0] {
            let motion = ConstantRate::new([100.0, 0.0, 0.0], [0.0, 1.0, 0.0], angle, [0.0; 3]);
            for timing in [Timing::Timed, Timing::Untimed] {
                assert_eq!(motion.rounded_arc([0.25, 1.0], timing).turns, [[1.0, 0.0, 0.0, 0.0]; 2], "{timing:?}");
            }
        }
    }

    #[test]
    fn the_bound_of_the_angle_holds_and_is_near() {
        for angle in [1e-3, 0.1, 0.5, 1.0, LARGEST_ANGLE] {
            let motion = ConstantRate::new([0.0; 3], [0.0, 0.0, 3.0], angle, [0.0; 3]);
            let tangent = libm::tan(angle / 4.0);
            let off = |i: u32| {
                let s = f64::from(i) / 1000.0;
                2.0 * (libm::atan((2.0 * s - 1.0) * tangent) - (2.0 * s - 1.0) * angle / 4.0).abs()
            };
            let largest = (0..=1000).map(off).fold(0.0, f64::max);
            let bound = motion.angle_off([0.0, 1.0]);
            assert!(largest <= bound && bound <= 1.15 * largest + 1e-13, "{angle}: {largest} of {bound}");
        }
    }
}
