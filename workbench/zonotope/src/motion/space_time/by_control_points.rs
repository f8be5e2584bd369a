//! The body at the middle of a rational motion and a box around the displacements.
//!
//! # Statement
//! Input: a rational motion, a body. Output: a zonotope that contains every placement exactly: the generators of the
//! body as it stands at the time 1/2, and one along each coordinate axis.
//!
//! # Source
//! Section 6, for motions that turn about several axes.
//!
//! # Method
//! On an arc between two quaternions the placement of a point x is a(s) + Σ B_i(s) M_i (x + w) / Σ B_i(s) d_i, B_i
//! the Bernstein polynomials of degree 2 and d_i > 0: a convex combination of the control points M_i (x + w) / d_i,
//! beside a segment. The displacement of x from the middle placement is linear in x at each of them, and largest along
//! a coordinate axis at a vertex of the body.
//!
//! The arc of each part of the motion is halved twice, exactly. Its quaternions p and q have no negative product,
//! so that the product of those at s and s′ is at least (1 − s)(1 − s′) |p|² + s s′ |q|². That is 0 for s = 0 and
//! s′ = 1 alone, so all d_i of a half are positive; the second halving makes the
//! box smaller.
//!
//! # Complexity
//! O(k n) exact operations for k parts and n generators.
//!
//! # Shapes
//! Input and output: centres and generators of space, generators in half-lengths; zero and parallel ones, none, and
//! bodies that the axis goes through are allowed.
//!
//! # Numerics
//! Everything is exact but the last rounding outward.
//!
//! # Errors
//! [`SweepError::OutOfRange`] ⇔ a coordinate of the volume is above the largest double.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), which holds exact placements against all facets.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::motion::{Motion, MotionPiece};
//! let quarter = MotionPiece {
//!     until: 1.0,
//!     from: [1.0, 0.0, 0.0, 0.0],
//!     to: [1.0, 0.0, 0.0, 1.0],
//!     axis_point: [0.0; 3],
//!     translation: [0.0; 3],
//! };
//! let bar = Zonotope::new([2.0, 0.0, 0.0], vec![[1.0, 0.0, 0.0]])?;
//! assert!(bar.swept(&Motion::from_pieces(&[quarter])?)?.contains([0.0, 3.0, 0.0])?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering;

use crate::motion::Motion;
use crate::motion::arc::Arc;
use crate::motion::constant_rate::Timing;
use crate::motion::quaternion::{image, polar_rotation};
use crate::motion::sweep::SweepError;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, dot, exact, multiple};
use crate::numeric::outward::{axis_generators, fraction_at_least};
use crate::zonotope::Zonotope;

/// The volume of a rational motion.
///
/// # Errors
/// [`SweepError::OutOfRange`] if it leaves the range of doubles.
pub(super) fn volume(motion: &Motion, body: &Zonotope<3>) -> Result<Zonotope<3>, SweepError> {
    let middle = Middle::of(&motion.exact_arc([0.5, 0.5], Timing::Timed));
    let mut bounds: [Option<[Rational; 2]>; 3] = [const { None }; 3];
    let times: Vec<f64> = [0.0].into_iter().chain(motion.breaks()).chain([1.0]).collect();
    for part in times.windows(2) {
        let whole = motion.exact_arc([part[0], part[1]], Timing::Timed);
        for arc in whole.halves().iter().flat_map(Arc::halves) {
            for (k, bounds) in bounds.iter_mut().enumerate() {
                *bounds = Some(around(bounds.take(), middle.displacements(&arc, body, k)));
            }
        }
    }
    middle.around(body, bounds.map(|bounds| bounds.unwrap_or([Rational::ZERO, Rational::ZERO])))
}

/// The least interval around two, or around one.
fn around(known: Option<[Rational; 2]>, [low, high]: [Rational; 2]) -> [Rational; 2] {
    match known {
        Some([least, most]) => [least.min(low), most.max(high)],
        None => [low, high],
    }
}

/// The placement at the middle: x ↦ (matrix (x + arm) + base) / …, each with its own denominator.
struct Middle {
    matrix: [ExactVector; 3],
    square: Dyadic,
    arm: ExactVector,
    base: ExactVector,
    weight: Dyadic,
}

impl Middle {
    fn of(arc: &Arc<Dyadic>) -> Self {
        let [q, _] = &arc.turns;
        Self {
            matrix: polar_rotation(q, q),
            square: crate::numeric::linear::dot(q, q),
            arm: arc.arm.clone(),
            base: arc.base[0].clone(),
            weight: arc.weight.clone(),
        }
    }

    /// Coordinate k of the middle placement of the origin.
    fn origin(&self, k: usize) -> Rational {
        let turned = dot(&self.matrix[k], &self.arm).to_rational() / self.square.to_rational();
        (turned + self.base[k].to_rational()) / self.weight.to_rational()
    }

    /// Bounds of how far points of the body are moved along a coordinate axis, from the middle placement to any of an
    /// arc.
    fn displacements(&self, arc: &Arc<Dyadic>, body: &Zonotope<3>, k: usize) -> [Rational; 2] {
        let center = exact(body.center());
        let weight = arc.weight.to_rational();
        let mut bounds: Option<[Rational; 2]> = None;
        for (matrix, square) in arc.rotations().iter().zip(arc.square()) {
            // row k of matrix / square − that of the middle, over both squares
            let (row, own) = (multiple(&self.square, &matrix[k]), multiple(&square, &self.matrix[k]));
            let row = crate::numeric::exact_linear::difference(&row, &own);
            let common = (&square * &self.square).to_rational();
            let reach = body.generators().iter().fold(Dyadic::zero(), |sum, g| sum + dot(&row, &exact(*g)).abs());
            let moved = dot(&row, &center).to_rational() / &common
                + dot(&matrix[k], &arc.arm).to_rational() / square.to_rational() / &weight
                - self.origin(k);
            let reach = reach.to_rational() / common;
            bounds = Some(around(bounds, [&moved - &reach, moved + reach]));
        }
        let bases = arc.base.each_ref().map(|base| base[k].to_rational() / &weight);
        let [low, high] = bounds.unwrap_or([Rational::ZERO, Rational::ZERO]);
        let [from, to] = bases;
        [low + from.clone().min(to.clone()), high + from.max(to)]
    }

    /// The body at the middle and a box.
    fn around(&self, body: &Zonotope<3>, bounds: [[Rational; 2]; 3]) -> Result<Zonotope<3>, SweepError> {
        let mut halves: [Rational; 3] = bounds.each_ref().map(|[low, high]| (high - low) / Rational::from(2));
        let square = self.square.to_rational();
        let mut lost = [const { Dyadic::zero() }; 3];
        let mut generators = Vec::with_capacity(body.generators().len() + 3);
        for g in body.generators() {
            let turned = image(&self.matrix, &exact(*g));
            let rounded = turned.each_ref().map(|c| c.rounded_ratio(&self.square));
            if rounded.iter().any(|c| !c.is_finite()) {
                return Err(SweepError::OutOfRange);
            }
            for k in 0..3 {
                let off = &turned[k] - &(&self.square * &Dyadic::from_f64(rounded[k]));
                lost[k] = &lost[k] + &off.abs();
            }
            generators.push(rounded);
        }
        let center = image(&self.matrix, &exact(body.center()));
        let mut rounded = [0.0; 3];
        for k in 0..3 {
            let [low, high] = &bounds[k];
            let exact = center[k].to_rational() / &square + self.origin(k) + (low + high) / Rational::from(2);
            rounded[k] = exact.to_f64_fast();
            if !rounded[k].is_finite() {
                return Err(SweepError::OutOfRange);
            }
            let off = exact - Dyadic::from_f64(rounded[k]).to_rational();
            let off = if off.cmp(&Rational::ZERO) == Ordering::Less { -off } else { off };
            halves[k] = &halves[k] + off + lost[k].to_rational() / &square;
        }
        generators.extend(axis_generators(halves.each_ref().map(fraction_at_least)));
        Ok(Zonotope::new(rounded, generators)?)
    }
}
