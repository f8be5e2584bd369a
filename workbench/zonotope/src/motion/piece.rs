//! A piece of a rational motion: a quaternion linear in time and a base that moves along a segment.

use super::arc::Arc;
use super::quaternion::{Quaternion, composition, conjugate, image, multiple, polar_rotation, sum};
use super::scalar::Scalar;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, ExactVector, exact};
use crate::numeric::linear::{dot, sum_norm};

/// The placements x ↦ P(s) + R(q(s)) (x + w) for times between two: s is linear in the time, P(s) = base + s travel.
/// The base and w are given times the weight, a positive number.
#[derive(Debug, Clone)]
struct Path<T> {
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
    exact: Path<Dyadic>,
    bounded: Path<Bounded>,
    rounded: Path<f64>,
    /// |base|_1 + |travel|_1, rounded.
    base_size: f64,
    is_translation: bool,
}

/// Where a body stands that has gone through some pieces: x ↦ (B + R̃(q) x |…|)/β, as q, B and β: R(q) x + B/β.
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
        // R(q) x + b goes to p + s v + R(q(s)) (R(turn) x + b − p), and b − p = R(turn) w
        let off = exact_linear::difference(offset, &exact_linear::multiple(weight, &point));
        let back = conjugate(turn);
        let arm = image(&polar_rotation(&back, &back), &off);
        let turned = weight * &dot(turn, turn);
        let scaled = |v: &ExactVector| exact_linear::multiple(&turned, v);
        let piece = Path {
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
        let path = Path {
            times: times.map(Dyadic::from_f64),
            turns: turns.map(|q| q.map(Dyadic::from_f64)),
            travel: exact_linear::difference(&end, &base),
            base,
            arm: exact([0.0; 3]),
            weight: Dyadic::one(),
        };
        Self::of(times, path)
    }

    fn of([from, until]: [f64; 2], mut path: Path<Dyadic>) -> Self {
        scale_down(path.turns.as_flattened_mut());
        let is_translation = path.turns[0] == path.turns[1];
        let rounded: Path<f64> = path.near();
        let base_size = sum_norm(&rounded.base) + sum_norm(&rounded.travel);
        Self { from, until, bounded: path.near(), rounded, base_size, exact: path, is_translation }
    }

    /// The same piece with all lengths times a power of two.
    pub(super) fn scaled(&self, exponent: i64) -> Self {
        let mut path = self.exact.clone();
        for list in [&mut path.base, &mut path.travel, &mut path.arm] {
            list.iter_mut().for_each(|c| *c = c.clone().scaled(exponent));
        }
        Self::of([self.from, self.until], path)
    }

    /// The binary exponent of the largest length, or one more.
    pub(super) fn size_exponent(&self) -> Option<i64> {
        let Path { base, travel, arm, weight, .. } = &self.exact;
        let largest = [base, travel, arm].into_iter().flatten().filter_map(Dyadic::binary_exponent).max()?;
        Some(largest - weight.binary_exponent()?)
    }

    /// Whether the body stays where it is.
    pub(super) fn is_rest(&self) -> bool {
        self.is_translation && self.exact.travel.iter().all(Dyadic::is_zero)
    }

    /// The stretch of the piece between two of its times, exactly.
    pub(super) fn exact_arc(&self, times: [f64; 2]) -> Arc<Dyadic> {
        self.between(&self.exact, times)
    }

    /// The same in doubles without bounds.
    pub(super) fn rounded_arc(&self, times: [f64; 2]) -> Arc<f64> {
        self.between(&self.rounded, times)
    }

    /// The stretch of the piece between two of its times, in doubles.
    pub(super) fn arc(&self, times: [f64; 2]) -> Arc<Bounded> {
        self.between(&self.bounded, times)
    }
}

impl Piece {
    /// The stretch between two times t of a path of the piece; the quaternions are times the length L of the path's
    /// time, the base times L and the weight.
    fn between<T: Scalar>(&self, path: &Path<T>, times: [f64; 2]) -> Arc<T> {
        let [start, end] = &path.times;
        let length = end.minus(start);
        let [from, to] = &path.turns;
        let turned = |t: f64| {
            let t = T::of(t);
            sum(&multiple(&end.minus(&t), from), &multiple(&t.minus(start), to))
        };
        let gone = |t: f64| {
            let passed = T::of(t).minus(start);
            [0, 1, 2].map(|k| length.times(&path.base[k]).plus(&passed.times(&path.travel[k])))
        };
        Arc {
            turns: if self.is_translation { [from.clone(), from.clone()] } else { times.map(turned) },
            base: times.map(gone),
            base_size: (self.until - self.from) * self.base_size,
            arm: path.arm.each_ref().map(|c| length.times(c)),
            weight: length.times(&path.weight),
            is_translation: self.is_translation,
        }
    }
}

impl Path<Dyadic> {
    /// The path in doubles, with or without bounds.
    fn near<T: Scalar>(&self) -> Path<T> {
        let vector = |v: &ExactVector| v.each_ref().map(T::near);
        Path {
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

/// Scales numbers by one power of two, such that the largest magnitude is between 1 and 2.
fn scale_down(numbers: &mut [Dyadic]) {
    let largest = numbers.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    numbers.iter_mut().for_each(|c| *c = c.clone().scaled(-largest));
}
