//! A piece of a rational motion: a quaternion linear in time and a base that moves along a segment.

use super::arc::Arc;
use super::quaternion::{Quaternion, composition, conjugate, image, multiple, polar_rotation, sum};
use super::scalar::Scalar;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, ExactVector, exact};
use crate::numeric::linear::{dot, sum_norm};
use crate::numeric::scaling::{binary_exponent, power_of_two};

/// A piece is short if it takes less than 2 to this power.
const SHORT_TIME: i32 = -32;

/// The largest exponent of a power of two by which times are multiplied: the smallest double becomes 2^-74.
const LARGEST_EXPONENT: i32 = 1000;

/// The binary exponent of lengths times their weight is at most this: sums and products with them stay in range.
const LARGEST_LENGTH: i64 = 900;

/// The placements x ↦ P(s) + R(q(s)) (x + w) for times between two: s is linear in the time, P(s) = base + s travel.
/// The base and w are given times the weight, a positive number.
#[derive(Debug, Clone)]
struct Course<T> {
    times: [T; 2],
    turns: [Quaternion<T>; 2],
    base: [T; 3],
    travel: [T; 3],
    arm: [T; 3],
    weight: T,
}

/// A piece, exactly and in doubles with bounds.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// The time at which it begins.
    pub(super) from: f64,
    /// The time at which it ends.
    pub(super) until: f64,
    exact: Course<Dyadic>,
    bounded: Course<Bounded>,
    rounded: Course<f64>,
    /// |base|_1 + |travel|_1, rounded.
    base_size: f64,
    /// The factor of all times: 1, or of a short piece a power of two, so that products of times do not vanish.
    time_factor: f64,
    is_translation: bool,
}

/// The placement of a body that has gone through some pieces: x ↦ R(q) x + B/β, by its quaternion q, the offset B and
/// the weight β.
#[derive(Debug, Clone)]
pub(super) struct Standing {
    turn: Quaternion<Dyadic>,
    offset: ExactVector,
    weight: Dyadic,
}

impl Standing {
    /// The body as it is.
    pub(super) fn at_rest() -> Self {
        Self { turn: super::quaternion::identity(), offset: exact([0.0; 3]), weight: Dyadic::one() }
    }
}

impl Piece {
    /// The piece that begins where a body stands, turns about an axis through a point by quaternions and translates;
    /// and where it leaves the body.
    pub(super) fn about_a_point(
        standing: &Standing,
        times: [f64; 2],
        [from, to]: [[f64; 4]; 2],
        axis_point: [f64; 3],
        translation: [f64; 3],
    ) -> (Self, Standing) {
        let (from, to) = (from.map(Dyadic::from_f64), to.map(Dyadic::from_f64));
        let [point, translation] = [axis_point, translation].map(exact);
        let Standing { turn, offset, weight } = standing;
        // R(turn) x + b goes to p + s v + R(q(s)) (R(turn) x + b − p), and b − p = R(turn) w
        let off = exact_linear::difference(offset, &exact_linear::multiple(weight, &point));
        let back = conjugate(turn);
        let arm = image(&polar_rotation(&back, &back), &off);
        let turned = weight * &dot(turn, turn);
        let scaled = |v: &ExactVector| exact_linear::multiple(&turned, v);
        let piece = Course {
            times: times.map(Dyadic::from_f64),
            turns: [composition(&from, turn), composition(&to, turn)],
            base: scaled(&point),
            travel: scaled(&translation),
            arm,
            weight: turned.clone(),
        };
        let square = dot(&to, &to);
        let end = exact_linear::multiple(&(&square * weight), &exact_linear::sum(&point, &translation));
        let left = Standing {
            turn: composition(&to, turn),
            offset: exact_linear::sum(&end, &image(&polar_rotation(&to, &to), &off)),
            weight: &square * weight,
        };
        (Self::of(times, piece), left.normalized())
    }

    /// The piece between two poses, each a quaternion and a translation.
    pub(super) fn between_poses(times: [f64; 2], turns: [[f64; 4]; 2], [from, to]: [[f64; 3]; 2]) -> Self {
        let [base, end] = [from, to].map(exact);
        let course = Course {
            times: times.map(Dyadic::from_f64),
            turns: turns.map(|q| q.map(Dyadic::from_f64)),
            travel: exact_linear::difference(&end, &base),
            base,
            arm: exact([0.0; 3]),
            weight: Dyadic::one(),
        };
        Self::of(times, course)
    }

    fn of([from, until]: [f64; 2], mut course: Course<Dyadic>) -> Self {
        scale_down(course.turns.as_flattened_mut());
        course.scale_weight();
        let is_translation = course.turns[0] == course.turns[1];
        let rounded: Course<f64> = course.near();
        let base_size = sum_norm(&rounded.base) + sum_norm(&rounded.travel);
        let bounded = course.near();
        let time_factor = factor_of_times(until - from);
        Self { from, until, bounded, rounded, base_size, time_factor, exact: course, is_translation }
    }

    /// The same piece with all lengths times a power of two.
    pub(super) fn scaled(&self, exponent: i64) -> Self {
        let mut course = self.exact.clone();
        for list in [&mut course.base, &mut course.travel, &mut course.arm] {
            list.iter_mut().for_each(|c| *c = c.clone().scaled(exponent));
        }
        Self::of([self.from, self.until], course)
    }

    /// The binary exponent of the largest length, or one more.
    pub(super) fn size_exponent(&self) -> Option<i64> {
        let Course { base, travel, arm, weight, .. } = &self.exact;
        let largest = [base, travel, arm].into_iter().flatten().filter_map(Dyadic::binary_exponent).max()?;
        Some(largest - weight.binary_exponent()?)
    }

    /// Whether the body stays where it is.
    pub(super) fn is_rest(&self) -> bool {
        self.is_translation && self.exact.travel.iter().all(Dyadic::is_zero)
    }

    /// The arc of the piece between two of its times, exactly.
    pub(super) fn exact_arc(&self, times: [f64; 2]) -> Arc<Dyadic> {
        self.between(&self.exact, times)
    }

    /// The same in doubles without bounds.
    pub(super) fn rounded_arc(&self, times: [f64; 2]) -> Arc<f64> {
        self.between(&self.rounded, times)
    }

    /// The same in doubles with bounds.
    pub(super) fn arc(&self, times: [f64; 2]) -> Arc<Bounded> {
        self.between(&self.bounded, times)
    }

    /// The arc between two times of the piece. Nothing is divided: with L the length of the piece's time,
    /// s = (t − start) / L, and so the quaternions, the base and w are given times L, and the weight is L times the
    /// course's own. Of a short piece, L is multiplied by a power of two, so that products of what is times L do not
    /// vanish in doubles.
    fn between<T: Scalar>(&self, course: &Course<T>, times: [f64; 2]) -> Arc<T> {
        let [start, end] = &course.times;
        let between = |from: &T, until: &T| {
            let time = until.minus(from);
            if self.time_factor == 1.0 { time } else { time.times(&T::of(self.time_factor)) }
        };
        let length = between(start, end);
        let [from, to] = &course.turns;
        let turned = |t: f64| {
            let t = T::of(t);
            sum(&multiple(&between(&t, end), from), &multiple(&between(start, &t), to))
        };
        let gone = |t: f64| {
            let passed = between(start, &T::of(t));
            [0, 1, 2].map(|k| length.times(&course.base[k]).plus(&passed.times(&course.travel[k])))
        };
        Arc {
            turns: if self.is_translation { [from.clone(), from.clone()] } else { times.map(turned) },
            base: times.map(gone),
            base_size: (self.until - self.from) * self.time_factor * self.base_size,
            arm: course.arm.each_ref().map(|c| length.times(c)),
            weight: length.times(&course.weight),
            is_translation: self.is_translation,
        }
    }
}

impl Course<Dyadic> {
    /// Scales all lengths and their weight by one power of two: the weight is between 1 and 2, or smaller where a
    /// length would leave the range of doubles. A weight that is denormal would lose the digits of every length.
    fn scale_weight(&mut self) {
        let lengths = || [&self.base, &self.travel, &self.arm].into_iter().flatten();
        let largest = lengths().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        let weight = self.weight.binary_exponent().unwrap_or(0);
        let exponent = (-weight).min(LARGEST_LENGTH - largest);
        if exponent != 0 {
            let Self { base, travel, arm, weight, .. } = self;
            let numbers = [base, travel, arm].into_iter().flatten().chain([weight]);
            numbers.for_each(|c| *c = c.clone().scaled(exponent));
        }
    }

    /// The course in doubles, with or without bounds.
    fn near<T: Scalar>(&self) -> Course<T> {
        let vector = |v: &ExactVector| v.each_ref().map(T::near);
        Course {
            times: self.times.each_ref().map(T::near),
            turns: self.turns.each_ref().map(|q| q.each_ref().map(T::near)),
            base: vector(&self.base),
            travel: vector(&self.travel),
            arm: vector(&self.arm),
            weight: T::near(&self.weight),
        }
    }
}

impl Standing {
    /// The same with numbers of ordinary size: the quaternion, and the offset with its weight, times powers of two.
    fn normalized(mut self) -> Self {
        scale_down(&mut self.turn);
        let [x, y, z] = self.offset;
        let mut place = [x, y, z, self.weight];
        scale_down(&mut place);
        let [x, y, z, weight] = place;
        Self { offset: [x, y, z], weight, ..self }
    }
}

/// The power of two by which a length of time is multiplied: 1 where it is not short.
fn factor_of_times(length: f64) -> f64 {
    match binary_exponent(length) {
        Some(exponent) if exponent < SHORT_TIME => power_of_two((-exponent).min(LARGEST_EXPONENT)),
        _ => 1.0,
    }
}

/// Scales numbers by one power of two, such that the largest magnitude is between 1 and 2.
pub(super) fn scale_down(numbers: &mut [Dyadic]) {
    let largest = numbers.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    numbers.iter_mut().for_each(|c| *c = c.clone().scaled(-largest));
}
