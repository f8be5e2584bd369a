//! Rigid motions of space over the time from 0 to 1.

use thiserror::Error;

use super::arc::Arc;
use super::constant_rate::{ConstantRate, LARGEST_ANGLE, Timing};
use super::piece::{Piece, Standing, scale_down};
use super::quaternion::polar_rotation;
use super::sweep::{Sweep, check_finite};
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::exact;
use crate::numeric::linear::dot;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::tolerance::MODERATE_SIZES;
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;

/// A rigid motion of space: a placement x ↦ R(t) x + v(t) for each time t from 0 to 1, R(t) a rotation.
///
/// Its numbers are taken exactly: of a rational motion ([`from_pieces`](Self::from_pieces),
/// [`through`](Self::through)) each placement at a rational time is a matrix of rationals; of one at constant rate the
/// angle is t times the given one, sine and cosine included.
#[derive(Debug, Clone)]
pub struct Motion(Kind);

#[derive(Debug, Clone)]
enum Kind {
    /// Pieces that follow each other from 0 to 1.
    Rational(Vec<Piece>),
    /// One rotation at constant rate from 0 to 1.
    ConstantRate(Box<ConstantRate>),
}

/// A part of a rational motion: x goes to p + R((1 − s) `from` + s `to`) (x − p) + s `translation`, where s goes from 0
/// to 1 with the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionPiece {
    /// The time at which the part ends; it begins where the one before it ends, the first one at 0.
    pub until: f64,
    /// The quaternion [w, x, y, z] at its begin, of any length but 0.
    pub from: [f64; 4],
    /// The quaternion at its end, of any length but 0 and not more than half a turn from the other.
    pub to: [f64; 4],
    /// The point p of the axis.
    pub axis_point: [f64; 3],
    /// The translation of the body at the end of the part.
    pub translation: [f64; 3],
}

/// A placement that a motion goes through at a time: a quaternion [w, x, y, z] of any length but 0, then a translation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KeyPose {
    /// The time from 0 to 1.
    pub time: f64,
    /// The quaternion; its negative is the same rotation.
    pub quaternion: [f64; 4],
    /// The image of the origin.
    pub translation: [f64; 3],
}

/// Why numbers are no motion.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A number is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// The axis of a rotation is the zero vector.
    #[error("the axis of the rotation is zero and has no direction")]
    ZeroAxis,
    /// A quaternion is zero.
    #[error("a quaternion of part or pose {part} of the motion is zero")]
    ZeroQuaternion {
        /// The index of the part, or of the pose.
        part: usize,
    },
    /// Two quaternions of a part are more than half a turn apart: their product is negative, and the shorter way
    /// between the rotations is that to the negative of one of them.
    #[error("the quaternions of part {part} of the motion are more than half a turn apart")]
    OppositeQuaternions {
        /// The index of the part.
        part: usize,
    },
    /// The first of several poses is not one at the time 0.
    #[error("the first pose is at the time {0} and must be at 0")]
    FirstPose(f64),
    /// The times of the parts do not go up from 0 to 1.
    #[error("part {part} of the motion ends at {until}: the times must go up, from above 0 to 1")]
    Times {
        /// The index of the part, between two poses that of the first of them, or how many there are, if the last one
        /// does not end at 1.
        part: usize,
        /// The time at which it ends, or the last one.
        until: f64,
    },
}

impl Motion {
    /// No motion: the body stays where it is.
    pub fn rest() -> Self {
        Self::translation([0.0; 3]).unwrap_or_else(|_| unreachable!("zero is finite"))
    }

    /// A translation along a segment.
    ///
    /// # Errors
    /// [`MotionError::NonFinite`] if a coordinate is not finite.
    pub fn translation(translation: [f64; 3]) -> Result<Self, MotionError> {
        let identity = [1.0, 0.0, 0.0, 0.0];
        Self::from_pieces(&[MotionPiece {
            until: 1.0,
            from: identity,
            to: identity,
            axis_point: [0.0; 3],
            translation,
        }])
    }

    /// The rotation at constant rate by an angle in radians about an axis through a point, of any length but 0, while
    /// the body translates: at the time t a point x is at R(t · angle) (x − p) + p + t · translation. The angle may be
    /// of several turns; a translation along the axis makes a screw.
    ///
    /// # Errors
    /// [`MotionError`] if a number is not finite or the axis is zero.
    pub fn constant_rate(
        axis_point: [f64; 3],
        axis: [f64; 3],
        angle: f64,
        translation: [f64; 3],
    ) -> Result<Self, MotionError> {
        check_finite(axis_point, axis, angle, translation)?;
        if axis == [0.0; 3] {
            return Err(MotionError::ZeroAxis);
        }
        Ok(Self(Kind::ConstantRate(Box::new(ConstantRate::new(axis_point, axis, angle, translation)))))
    }

    /// A rational motion of parts, each applied after those before it. A part that begins with another quaternion than
    /// a multiple of 1 begins with a jump; at that time both placements count.
    ///
    /// # Errors
    /// [`MotionError`] names the first part that has a number that is not finite, a quaternion of length 0, two
    /// quaternions more than half a turn apart, or a time that does not follow.
    pub fn from_pieces(parts: &[MotionPiece]) -> Result<Self, MotionError> {
        let mut standing = Standing::at_rest();
        let mut pieces = Vec::with_capacity(parts.len());
        let mut start = 0.0;
        for (part, piece) in parts.iter().enumerate() {
            NonFinite::check_vector("a time of the motion", &[piece.until])?;
            NonFinite::check_vector("an axis point of the motion", &piece.axis_point)?;
            NonFinite::check_vector("a translation of the motion", &piece.translation)?;
            check_quaternions(part, &[piece.from, piece.to])?;
            if is_negative_product(&piece.from, &piece.to) {
                return Err(MotionError::OppositeQuaternions { part });
            }
            check_time(part, start, piece.until)?;
            let turns = [piece.from, piece.to];
            let (made, left) =
                Piece::about_a_point(&standing, [start, piece.until], turns, piece.axis_point, piece.translation);
            pieces.push(made);
            (standing, start) = (left, piece.until);
        }
        Self::of_pieces(pieces)
    }

    /// The rational motion through poses, the first at the time 0 and the last at 1: between two of them the
    /// quaternion goes linearly along the shorter arc, where both ways are half a turn, the one to the
    /// quaternion as it is given, and the translation goes linearly, too.
    ///
    /// # Errors
    /// [`MotionError`] names the first pose with a number that is not finite, a quaternion of length 0, or a time that
    /// does not follow.
    pub fn through(poses: &[KeyPose]) -> Result<Self, MotionError> {
        for (part, pose) in poses.iter().enumerate() {
            NonFinite::check_vector("a time of the motion", &[pose.time])?;
            NonFinite::check_vector("a translation of the motion", &pose.translation)?;
            check_quaternions(part, &[pose.quaternion])?;
        }
        if let Some(first) = poses.first().filter(|first| first.time != 0.0) {
            return Err(MotionError::FirstPose(first.time));
        }
        let mut pieces = Vec::with_capacity(poses.len());
        let mut before = poses.first().map_or([0.0; 4], |pose| pose.quaternion);
        for (part, pair) in poses.windows(2).enumerate() {
            let [from, to] = [pair[0], pair[1]];
            check_time(part, from.time, to.time)?;
            let sign = if is_negative_product(&before, &to.quaternion) { -1.0 } else { 1.0 };
            let next = to.quaternion.map(|c| sign * c);
            let translations = [from.translation, to.translation];
            pieces.push(Piece::between_poses([from.time, to.time], [before, next], translations));
            before = next;
        }
        Self::of_pieces(pieces)
    }

    fn of_pieces(pieces: Vec<Piece>) -> Result<Self, MotionError> {
        match pieces.last() {
            Some(last) if last.until == 1.0 => Ok(Self(Kind::Rational(pieces))),
            last => Err(MotionError::Times { part: pieces.len(), until: last.map_or(0.0, |last| last.until) }),
        }
    }

    /// The placement at a time from 0 to 1, rounded: a matrix that is a rotation but for rounding, and a translation.
    /// `None` at another time, and where a coordinate leaves the range of doubles.
    pub fn pose_at(&self, time: f64) -> Option<Pose> {
        if !(0.0..=1.0).contains(&time) {
            return None;
        }
        let arc = self.rounded_arc([time, time], Timing::Timed);
        let turn = match &arc.turns[0] {
            turn if MODERATE_SIZES.contains(&dot(turn, turn)) => *turn,
            // one whose square leaves the doubles, times a power of two
            _ => {
                let [mut turn, _] = self.exact_arc([time, time], Timing::Timed).turns;
                scale_down(&mut turn);
                turn.each_ref().map(Dyadic::to_f64)
            }
        };
        let square = dot(&turn, &turn);
        let mut rotation = polar_rotation(&turn, &turn);
        rotation.as_flattened_mut().iter_mut().for_each(|c| *c /= square);
        let arm = arc.arm.map(|c| c / arc.weight);
        let moved = |k: usize| dot(&rotation[k], &arm) + arc.base[0][k] / arc.weight;
        Pose::new(rotation, [0, 1, 2].map(moved)).ok()
    }

    /// The same motion with all lengths times a power of two, exactly; `None` where they leave the range of doubles.
    pub(super) fn scaled(&self, exponent: i64) -> Option<Self> {
        match &self.0 {
            Kind::Rational(pieces) => {
                Some(Self(Kind::Rational(pieces.iter().map(|piece| piece.scaled(exponent)).collect())))
            }
            Kind::ConstantRate(motion) => Some(Self(Kind::ConstantRate(Box::new(motion.scaled(exponent)?)))),
        }
    }

    /// The binary exponent of the largest length, or one more; `None` where all are zero.
    pub(super) fn size_exponent(&self) -> Option<i64> {
        match &self.0 {
            Kind::Rational(pieces) => pieces.iter().filter_map(Piece::size_exponent).max(),
            Kind::ConstantRate(motion) => motion.size_exponent(),
        }
    }

    /// The sweep that contains the placements of a motion that is not rational. It is `None` for a rational motion
    /// alone, as [`Zonotope::swept`](crate::Zonotope::swept) takes every motion without a sweep for rational.
    pub(super) fn as_sweep(&self) -> Option<Sweep> {
        match &self.0 {
            Kind::Rational(_) => None,
            Kind::ConstantRate(motion) => Some(motion.as_sweep()),
        }
    }

    /// Whether the placements at rational times are rational.
    pub fn is_rational(&self) -> bool {
        matches!(self.0, Kind::Rational(_))
    }

    /// Whether the motion turns about an axis that stays where it is, at constant rate.
    pub(super) fn only_turns(&self) -> bool {
        match &self.0 {
            Kind::Rational(_) => false,
            Kind::ConstantRate(motion) => motion.only_turns(),
        }
    }

    /// Whether the body stays where it is, at every time.
    pub(super) fn is_rest(&self) -> bool {
        match &self.0 {
            Kind::Rational(pieces) => matches!(pieces.as_slice(), [piece] if piece.is_rest()),
            Kind::ConstantRate(motion) => motion.angle() == 0.0 && motion.only_turns(),
        }
    }

    /// The times strictly between two others at which an arc must end: those at which a part of the motion ends.
    pub(super) fn breaks(&self) -> impl Iterator<Item = f64> + '_ {
        let pieces: &[Piece] = match &self.0 {
            Kind::Rational(pieces) => pieces,
            Kind::ConstantRate(_) => &[],
        };
        pieces.iter().skip(1).map(|piece| piece.from)
    }

    /// Whether the motion between two times is one arc: of a rotation at constant rate, at most a quarter turn.
    pub(super) fn is_one_arc(&self, [from, to]: [f64; 2]) -> bool {
        match &self.0 {
            Kind::Rational(pieces) => self.piece_at(pieces, [from, to]).until >= to,
            Kind::ConstantRate(motion) => motion.angle().abs() * (to - from) <= LARGEST_ANGLE,
        }
    }

    /// The number of quarter turns that a motion at its largest rate would make between two times, by which the time is
    /// cut evenly; 0 for rational motions, each part of which is one arc.
    pub(super) fn quarter_turns(&self, [from, to]: [f64; 2]) -> f64 {
        match &self.0 {
            Kind::Rational(_) => 0.0,
            Kind::ConstantRate(motion) => motion.angle().abs() * (to - from) / LARGEST_ANGLE,
        }
    }

    /// The motion between two times within one arc, exactly; for constant rate a motion near it.
    pub(super) fn exact_arc(&self, times: [f64; 2], timing: Timing) -> Arc<Dyadic> {
        match &self.0 {
            Kind::Rational(pieces) => self.piece_at(pieces, times).exact_arc(times),
            Kind::ConstantRate(motion) => motion.exact_arc(times, timing),
        }
    }

    /// The same in doubles with bounds.
    pub(super) fn arc(&self, times: [f64; 2], timing: Timing) -> Arc<Bounded> {
        match &self.0 {
            Kind::Rational(pieces) => self.piece_at(pieces, times).arc(times),
            Kind::ConstantRate(motion) => motion.arc(times, timing),
        }
    }

    /// The same in doubles without bounds.
    pub(super) fn rounded_arc(&self, times: [f64; 2], timing: Timing) -> Arc<f64> {
        match &self.0 {
            Kind::Rational(pieces) => self.piece_at(pieces, times).rounded_arc(times),
            Kind::ConstantRate(motion) => motion.rounded_arc(times, timing),
        }
    }

    /// A bound of the angle between the motion and its arc, at any time of the arc; 0 for rational motions.
    pub(super) fn angle_off(&self, times: [f64; 2]) -> f64 {
        match &self.0 {
            Kind::Rational(_) => 0.0,
            Kind::ConstantRate(motion) => motion.angle_off(times),
        }
    }

    /// The unit vector of the axis of a rotation at constant rate, rounded; zero for rational motions.
    pub(super) fn unit_axis(&self) -> [f64; 3] {
        match &self.0 {
            Kind::Rational(_) => [0.0; 3],
            Kind::ConstantRate(motion) => motion.unit_axis(),
        }
    }

    /// A bound above the distance of a body's points from the axis of a rotation at constant rate; 0 for rational
    /// motions, which have no need of it.
    pub(super) fn distance_from_axis(&self, body: &Zonotope<3>) -> f64 {
        match &self.0 {
            Kind::Rational(_) => 0.0,
            Kind::ConstantRate(motion) => motion.distance_from_axis(body),
        }
    }

    /// The piece on which an arc begins: of two that meet there the later one, at the time 1 the last one.
    fn piece_at<'a>(&self, pieces: &'a [Piece], [from, _]: [f64; 2]) -> &'a Piece {
        let next = pieces.partition_point(|piece| piece.from <= from).max(1);
        &pieces[next - 1]
    }
}

fn check_quaternions(part: usize, quaternions: &[[f64; 4]]) -> Result<(), MotionError> {
    for quaternion in quaternions {
        NonFinite::check_vector("a quaternion of the motion", quaternion)?;
        if *quaternion == [0.0; 4] {
            return Err(MotionError::ZeroQuaternion { part });
        }
    }
    Ok(())
}

fn check_time(part: usize, from: f64, until: f64) -> Result<(), MotionError> {
    let follows = from < until && until <= 1.0;
    if follows { Ok(()) } else { Err(MotionError::Times { part, until }) }
}

fn is_negative_product(q: &[f64; 4], r: &[f64; 4]) -> bool {
    dot(&exact(*q), &exact(*r)).sign().is_lt()
}

#[cfg(test)]
mod tests;
