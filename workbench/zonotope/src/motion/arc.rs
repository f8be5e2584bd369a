//! An arc, a motion between two times: placements x ↦ P(s) + R(q(s)) (x + w), P and q linear in s on [0, 1].

use super::bernstein;
use super::quaternion::{Quaternion, composition, conjugate, image, polar_rotation, sum, transposed_image};
use super::scalar::Scalar;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{Ring, dot};

/// A motion between two times, over the numbers T. P and w are given times a positive number, the weight, so that
/// nothing is divided where an arc is cut out of a motion.
#[derive(Debug, Clone)]
pub(super) struct Arc<T> {
    /// q at both ends, of any length.
    pub(super) turns: [Quaternion<T>; 2],
    /// The weight times P at both ends.
    pub(super) base: [[T; 3]; 2],
    /// A bound of |t|_1 summed over the terms t of which a base is computed, times the weight, but for a few roundings:
    /// what the rounding of a base is measured by.
    pub(super) base_size: f64,
    /// The weight times w.
    pub(super) arm: [T; 3],
    /// The weight.
    pub(super) weight: T,
    /// Whether both quaternions are the same: the arc translates alone.
    pub(super) is_translation: bool,
}

impl<T: Scalar> Arc<T> {
    /// |q(s)|² by its scaled Bernstein coefficients.
    #[inline]
    pub(super) fn square(&self) -> [T; 3] {
        let [p, q] = &self.turns;
        let mixed = dot(p, q);
        [dot(p, p), mixed.plus(&mixed), dot(q, q)]
    }

    /// The matrices of |q(s)|² R(q(s)) as scaled Bernstein coefficients.
    #[inline]
    pub(super) fn rotations(&self) -> [[[T; 3]; 3]; 3] {
        let [p, q] = &self.turns;
        let first = polar_rotation(p, p);
        if self.is_translation {
            let mixed = twice(&first);
            return [first.clone(), mixed, first];
        }
        [first, twice(&polar_rotation(p, q)), polar_rotation(q, q)]
    }

    /// The matrices of |q|² |r|² R(q)⁻¹ R(r), the turn of another body as this one sees it, as scaled Bernstein
    /// coefficients.
    #[inline]
    pub(super) fn rotations_seen(&self, other: &Self) -> [[[T; 3]; 3]; 5] {
        let [p, q] = self.turns.each_ref().map(conjugate);
        let [r, s] = &other.turns;
        let relative = [composition(&p, r), sum(&composition(&p, s), &composition(&q, r)), composition(&q, s)];
        let [first, middle, last] = &relative;
        let (ends, square) = (twice(&polar_rotation(first, last)), polar_rotation(middle, middle));
        let center = std::array::from_fn(|i| std::array::from_fn(|j| ends[i][j].plus(&square[i][j])));
        [
            polar_rotation(first, first),
            twice(&polar_rotation(first, middle)),
            center,
            twice(&polar_rotation(middle, last)),
            polar_rotation(last, last),
        ]
    }

    /// The weight times the centre c + w of a body's arm.
    #[inline]
    pub(super) fn arm_of(&self, center: &[f64; 3]) -> [T; 3] {
        [0, 1, 2].map(|k| self.weight.times(&T::of(center[k])).plus(&self.arm[k]))
    }

    /// u · P(s) times the weight for a fixed direction.
    #[inline]
    pub(super) fn base_along(&self, u: &[T; 3]) -> [T; 2] {
        self.base.each_ref().map(|base| dot(u, base))
    }
}

impl Arc<Dyadic> {
    /// The arc in numbers near the exact ones.
    pub(super) fn near<T: Scalar>(&self) -> Arc<T> {
        let vector = |v: &[Dyadic; 3]| v.each_ref().map(T::near);
        Arc {
            turns: self.turns.each_ref().map(|q| q.each_ref().map(T::near)),
            base: self.base.each_ref().map(vector),
            base_size: self.base_size,
            arm: vector(&self.arm),
            weight: T::near(&self.weight),
            is_translation: self.is_translation,
        }
    }

    /// The halves of the arc, exactly: no times are halved, between which there may be no double.
    pub(super) fn halves(&self) -> [Self; 2] {
        let mean = |a: &Dyadic, b: &Dyadic| a.plus(b).scaled(-1);
        let ([p, q], [from, to]) = (&self.turns, &self.base);
        let turn: Quaternion<Dyadic> = [0, 1, 2, 3].map(|k| mean(&p[k], &q[k]));
        let base = [0, 1, 2].map(|k| mean(&from[k], &to[k]));
        let half = |turns, base| Self { turns, base, ..self.clone() };
        [half([p.clone(), turn.clone()], [from.clone(), base.clone()]), half([turn, q.clone()], [base, to.clone()])]
    }
}

impl Arc<Bounded> {
    /// The arc in doubles, without its bounds.
    pub(super) fn rounded(&self) -> Arc<f64> {
        let vector = |v: &[Bounded; 3]| v.map(|c| c.value);
        Arc {
            turns: self.turns.map(|q| q.map(|c| c.value)),
            base: self.base.each_ref().map(vector),
            base_size: self.base_size,
            arm: vector(&self.arm),
            weight: self.weight.value,
            is_translation: self.is_translation,
        }
    }
}

impl Arc<f64> {
    /// A direction of space as the body sees it at the middle of the arc, of any length.
    pub(super) fn turned_back(&self, u: &[f64; 3]) -> [f64; 3] {
        let middle = sum(&self.turns[0], &self.turns[1]);
        transposed_image(&polar_rotation(&middle, &middle), u)
    }

    /// The place of a point of the body at the middle of the arc.
    pub(super) fn middle_of(&self, x: &[f64; 3]) -> [f64; 3] {
        let middle = sum(&self.turns[0], &self.turns[1]);
        let (turned, square) = (image(&polar_rotation(&middle, &middle), &self.arm_of(x)), dot(&middle, &middle));
        let [from, to] = self.base;
        [0, 1, 2].map(|k| (turned[k] / square + (from[k] + to[k]) / 2.0) / self.weight)
    }
}

/// Twice a matrix.
#[inline]
fn twice<T: Scalar>(matrix: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    matrix.each_ref().map(|row| row.each_ref().map(|c| c.plus(c)))
}

/// The path from one body's base to another's, times the weights of both.
pub(super) fn displacement<T: Scalar>(a: &Arc<T>, b: &Arc<T>) -> [[T; 3]; 2] {
    [0, 1].map(|end| {
        let [from, to] = [bernstein::multiple(&b.weight, &a.base[end]), bernstein::multiple(&a.weight, &b.base[end])];
        bernstein::difference(&to, &from)
    })
}
