//! Rigid motions as a question states them, and their stretches between two times in whole numbers.

use dashu_int::IBig;

use super::quaternion::{
    Quaternion, Vector, conjugate, difference, dot, identity, image, mixed_rotation, multiple, product, sum,
};
use super::stretch::Stretch;
use super::turning::Turning;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::reduced;

/// A motion during the time from 0 to 1, as the exact numbers that a question states.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// The body rests.
    Rest,
    /// At the time t a point x is at R(t · angle) (x − axis_point) + axis_point + t · translation.
    ConstantRate {
        /// A point of the axis.
        axis_point: [f64; 3],
        /// The axis, of any length but 0.
        axis: [f64; 3],
        /// The angle in radians.
        angle: f64,
        /// The translation.
        translation: [f64; 3],
    },
    /// Pieces, each applied after those before it.
    Pieces(Vec<MotionPiece>),
}

/// A piece of a motion: x goes to p + R((1 − s) `from` + s `to`) (x − p) + s `translation`, s from 0 to 1 with the
/// time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionPiece {
    /// The time at which it ends.
    pub until: f64,
    /// The quaternion [w, x, y, z] at its begin.
    pub from: [f64; 4],
    /// The quaternion at its end, at most half a turn from the other.
    pub to: [f64; 4],
    /// The point p of the axis.
    pub axis_point: [f64; 3],
    /// The translation at its end.
    pub translation: [f64; 3],
}

impl Motion {
    /// The numbers that are lengths.
    pub(super) fn lengths(&self) -> Vec<f64> {
        match self {
            Self::Rest => Vec::new(),
            Self::ConstantRate { axis_point, translation, .. } => [*axis_point, *translation].concat(),
            Self::Pieces(pieces) => {
                pieces.iter().flat_map(|piece| [piece.axis_point, piece.translation]).flatten().collect()
            }
        }
    }

    /// Refuses numbers that are not finite.
    pub(super) fn check_finite(&self) -> Result<(), String> {
        check_finite("a motion", &self.lengths())?;
        match self {
            Self::Rest => Ok(()),
            Self::ConstantRate { axis, angle, .. } => check_finite("a motion", axis.iter().chain([angle])),
            Self::Pieces(pieces) => {
                let numbers = |piece: &MotionPiece| [&piece.from[..], &piece.to, &[piece.until]].concat();
                check_finite("a motion", &pieces.iter().flat_map(numbers).collect::<Vec<_>>())
            }
        }
    }
}

/// A motion in whole numbers.
#[derive(Debug, Clone)]
pub(super) enum Path {
    Turning(Box<Turning>),
    Pieces(Vec<Piece>),
}

/// A piece after all that came before it: x ↦ p + s v + R(q(s)) (x + arm / weight).
#[derive(Debug, Clone)]
pub(super) struct Piece {
    times: [f64; 2],
    turns: [Quaternion; 2],
    point: Vector,
    travel: Vector,
    arm: Vector,
    weight: IBig,
}

impl Path {
    /// The motion in units of lengths.
    ///
    /// # Errors
    /// A sentence about numbers that are no motion.
    pub(super) fn of(motion: &Motion, lengths: Grid) -> Result<Self, String> {
        motion.check_finite()?;
        let vector = |v: &[f64; 3]| v.map(|c| lengths.units(c));
        match motion {
            Motion::Rest => Ok(Self::Pieces(vec![resting()])),
            Motion::ConstantRate { axis_point, axis, angle, translation } => {
                Turning::new(vector(axis_point), vector(translation), *axis, *angle)
                    .map(|turning| Self::Turning(Box::new(turning)))
                    .ok_or_else(|| "answered a question about a rotation with an axis of zero".to_owned())
            }
            Motion::Pieces(pieces) => chained(pieces, vector).map(Self::Pieces),
        }
    }

    /// Whether the body turns about an axis that stays where it is, at constant rate.
    pub(super) fn only_turns(&self) -> bool {
        matches!(self, Self::Turning(turning) if turning.only_turns())
    }

    /// Whether the body stays where it is.
    pub(super) fn is_rest(&self) -> bool {
        let is_zero = |v: &Vector| v.iter().all(|c| *c == IBig::ZERO);
        match self {
            Self::Turning(turning) => turning.is_rest(),
            Self::Pieces(pieces) => {
                matches!(pieces.as_slice(), [piece] if piece.turns[0] == piece.turns[1] && is_zero(&piece.travel))
            }
        }
    }

    /// The times at which a stretch must end.
    pub(super) fn breaks(&self) -> impl Iterator<Item = f64> + '_ {
        let pieces: &[Piece] = if let Self::Pieces(pieces) = self { pieces } else { &[] };
        pieces.iter().skip(1).map(|piece| piece.times[0])
    }

    /// Whether the motion between two times, in units of 2^-`places`, that no break lies between is one stretch.
    pub(super) fn is_one_stretch(&self, times: [&IBig; 2], places: usize) -> bool {
        match self {
            Self::Turning(turning) => turning.is_one_stretch(times, places),
            Self::Pieces(_) => true,
        }
    }

    /// The stretches between two times: one, or two where both times are one at which a piece ends and another begins.
    pub(super) fn stretches(&self, times: [&IBig; 2], places: usize) -> Vec<Stretch> {
        match self {
            Self::Turning(turning) => vec![turning.stretch(times, places)],
            Self::Pieces(pieces) => pieces.iter().filter_map(|piece| piece.stretch(times, places)).collect(),
        }
    }

    /// A bound of the distances of a body's points from the axis, in units 2^-32 of those of lengths; 0 where stretches
    /// are exact.
    pub(super) fn reach(&self, center: &Vector, generators: &[Vector]) -> IBig {
        match self {
            Self::Turning(turning) => turning.reach(center, generators),
            Self::Pieces(_) => IBig::ZERO,
        }
    }
}

impl Piece {
    /// The stretch between two times, if the piece holds both.
    fn stretch(&self, [from, to]: [&IBig; 2], places: usize) -> Option<Stretch> {
        let exponent = i32::try_from(places).ok()?;
        let [start, end] = self.times.map(|time| Grid::at(-exponent).units(time));
        if *from < start || *to > end {
            return None;
        }
        let length = &end - &start;
        let turned =
            |time: &IBig| sum(&multiple(&(&end - time), &self.turns[0]), &multiple(&(time - &start), &self.turns[1]));
        let gone = |time: &IBig| {
            let path = sum(&multiple(&length, &self.point), &multiple(&(time - &start), &self.travel));
            multiple(&self.weight, &path)
        };
        let turns = if self.turns[0] == self.turns[1] {
            vec![self.turns[0].clone()]
        } else if from == to {
            vec![turned(from)]
        } else {
            vec![turned(from), turned(to)]
        };
        Some(Stretch {
            turns,
            base: [gone(from), gone(to)],
            arm: multiple(&length, &self.arm),
            weight: length * &self.weight,
            ends_off: [IBig::ZERO, IBig::ZERO],
            chord: IBig::ZERO,
            axis: None,
        })
    }
}

fn resting() -> Piece {
    let zero = || [IBig::ZERO, IBig::ZERO, IBig::ZERO];
    let turns = [identity(), identity()];
    Piece { times: [0.0, 1.0], turns, point: zero(), travel: zero(), arm: zero(), weight: IBig::ONE }
}

/// The pieces, each after those before it.
///
/// After some pieces the body stands at R(Q) x + o / w. The next one takes it to
/// p + s v + R(q) (R(Q) x + o / w − p) = p + s v + R(q Q) (x + R(Q)⁻¹ (o − w p) / w).
fn chained(pieces: &[MotionPiece], vector: impl Fn(&[f64; 3]) -> Vector) -> Result<Vec<Piece>, String> {
    let mut turned = identity();
    let mut offset: Vector = [IBig::ZERO, IBig::ZERO, IBig::ZERO];
    let mut weight = IBig::ONE;
    let mut start = 0.0;
    let mut all = Vec::with_capacity(pieces.len());
    for piece in pieces {
        if !(start < piece.until && piece.until <= 1.0) {
            return Err("answered a question about a motion whose times do not go up to 1".to_owned());
        }
        let grid = Grid::of(piece.from.into_iter().chain(piece.to));
        let [from, to] = [piece.from, piece.to].map(|q| q.map(|c| grid.units(c)));
        let is_zero = |q: &Quaternion| q.iter().all(|c| *c == IBig::ZERO);
        if is_zero(&from) || is_zero(&to) || dot(&from, &to) < IBig::ZERO {
            return Err("answered a question about quaternions that are zero or more than half a turn apart".to_owned());
        }
        let (point, travel) = (vector(&piece.axis_point), vector(&piece.translation));
        let off = difference(&offset, &multiple(&weight, &point));
        let back = conjugate(&turned);
        let [arm @ .., arm_weight] =
            without_divisor(&image(&mixed_rotation(&back, &back), &off), &weight * dot(&turned, &turned));
        let turns = [product(&from, &turned), product(&to, &turned)];
        // p + v + R(to) (o − w p) / w, over w |to|²
        let square = dot(&to, &to);
        let end = multiple(&(&weight * &square), &sum(&point, &travel));
        let [next @ .., next_weight] =
            without_divisor(&sum(&end, &image(&mixed_rotation(&to, &to), &off)), &weight * &square);
        turned = <Quaternion>::try_from(reduced(turns[1].to_vec())).unwrap_or_else(|_| turns[1].clone());
        (offset, weight) = (next, next_weight);
        all.push(Piece { times: [start, piece.until], turns, point, travel, arm, weight: arm_weight });
        start = piece.until;
    }
    if start == 1.0 { Ok(all) } else { Err("answered a question about a motion that does not end at 1".to_owned()) }
}

/// A vector and its weight without their greatest common divisor.
fn without_divisor([x, y, z]: &Vector, weight: IBig) -> [IBig; 4] {
    let all = [x.clone(), y.clone(), z.clone(), weight];
    <[IBig; 4]>::try_from(reduced(all.to_vec())).unwrap_or(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STILL: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
    const QUARTER: [f64; 4] = [1.0, 0.0, 0.0, 1.0];

    fn piece(until: f64, from: [f64; 4], to: [f64; 4]) -> MotionPiece {
        MotionPiece { until, from, to, axis_point: [0.0; 3], translation: [0.0; 3] }
    }

    fn path(pieces: &[MotionPiece]) -> Result<Path, String> {
        Path::of(&Motion::Pieces(pieces.to_vec()), Grid::at(0))
    }

    #[test]
    fn quaternions_go_linearly_from_the_begin_of_a_piece_to_its_end() {
        let path = path(&[piece(0.5, STILL, STILL), piece(1.0, STILL, QUARTER)]).expect("a motion");
        // Times are in eighths, of which the second piece has those from 4 to 8.
        let turns = |from: i32, to: i32| {
            let stretches = path.stretches([&IBig::from(from), &IBig::from(to)], 3);
            stretches.into_iter().map(|stretch| stretch.turns).collect::<Vec<_>>()
        };
        let of = |q: [i32; 4]| q.map(IBig::from);
        assert_eq!(turns(5, 5), [[of([4, 0, 0, 1])]]);
        assert_eq!(turns(6, 8), [[of([4, 0, 0, 2]), of([4, 0, 0, 4])]]);
        assert_eq!(turns(1, 3), [[of([1, 0, 0, 0])]]);
        assert_eq!(turns(4, 4).len(), 2, "a piece ends and another begins");
        assert!(turns(3, 5).is_empty(), "no piece holds both times");
    }

    #[test]
    fn the_times_of_pieces_go_up_to_one() {
        let ends_at = |times: &[f64]| path(&times.iter().map(|&until| piece(until, STILL, STILL)).collect::<Vec<_>>());
        assert!(ends_at(&[1.0]).is_ok() && ends_at(&[0.25, 0.5, 1.0]).is_ok());
        for wrong in
            [&[0.0, 1.0][..], &[0.5, 0.5, 1.0], &[0.75, 0.5, 1.0], &[1.5, 1.0], &[1.0, 1.5], &[0.5], &[-1.0, 1.0]]
        {
            assert!(ends_at(wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn a_piece_turns_by_half_a_turn_at_most_and_has_quaternions_of_some_length() {
        let turns = |from: [f64; 4], to: [f64; 4]| path(&[piece(1.0, from, to)]).is_ok();
        assert!(turns(STILL, QUARTER) && turns(STILL, [0.0, 0.0, 0.0, 1.0]), "half a turn is the most");
        assert!(turns([0.5, 0.5, -0.5, 0.5], [1.0, 2.0, 3.0, 4.0]));
        assert!(!turns(STILL, [-0.125, 0.0, 0.0, 1.0]));
        assert!(!turns([0.0; 4], STILL) && !turns(STILL, [0.0; 4]) && !turns([0.0; 4], [0.0; 4]));
    }

    #[test]
    fn a_turn_at_constant_rate_is_one_stretch_up_to_an_angle() {
        let motion = |angle: f64| Motion::ConstantRate {
            axis_point: [0.0; 3],
            axis: [0.0, 0.0, 1.0],
            angle,
            translation: [0.0; 3],
        };
        let is_one = |motion: &Motion, places: usize| {
            let path = Path::of(motion, Grid::at(0)).expect("a motion");
            path.is_one_stretch([&IBig::ZERO, &IBig::ONE], places)
        };
        // Half of the time is half of the angle.
        for angle in [2.0, -2.0, 3.0] {
            assert!(!is_one(&motion(angle), 0) && is_one(&motion(angle), 1), "{angle}");
        }
        assert!(is_one(&Motion::Rest, 0));
    }
}
