//! The truth about moving bodies at one rational time: placements and gaps in rationals, from the definition.
//!
//! # Statement
//! Input: the parts of a rational motion and a time; two bodies placed, and a direction that may turn with one of them.
//! Output: the placement as a matrix and a translation; the gap along the direction, positive just when it separates
//! the bodies.
//!
//! # Source
//! Section 6: what a rigid motion does to a body.
//!
//! # Method
//! One part after the other is applied; the rotation of a quaternion is written out entry by entry.
//!
//! # Complexity
//! O(k) for k parts, O(n) for the gap of n generators, in rationals that grow with the parts.
//!
//! # Shapes
//! `parts`: as [`Motion::from_pieces`](crate::motion::Motion::from_pieces) takes them; times in [0, 1].
//!
//! # Numerics
//! Everything is exact.
//!
//! # Panics
//! If the index is not that of a part.
//!
//! # Checked by
//! It is the truth of the module; a quarter turn is worked out by hand below.
//!
//! # Example
//! ```
//! use zonotope::motion::{MotionPiece, continuous::brute_force::Placement};
//! use zonotope::numeric::Rational;
//! // from 1 to 1 + k, a quarter turn about z
//! let [from, to] = [[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0]];
//! let part = MotionPiece { until: 1.0, from, to, axis_point: [0.0; 3], translation: [0.0; 3] };
//! let end = Placement::at(&[part], 0, &Rational::ONE);
//! assert_eq!(end.of([3.0, 0.0, 5.0]).map(|c| c.to_f64().value()), [0.0, 3.0, 5.0]);
//! ```

use super::SeparatingDirection;
use crate::motion::MotionPiece;
use crate::numeric::Rational;
use crate::numeric::exact_linear::rational;
use crate::numeric::linear::{cross, dot};
use crate::zonotope::Zonotope;

/// A placement x ↦ M x + v.
pub struct Placement {
    matrix: [[Rational; 3]; 3],
    translation: [Rational; 3],
}

impl Placement {
    /// The placement at a time during the part of an index; at a time that ends a part, the next one may begin with a
    /// jump.
    pub fn at(parts: &[MotionPiece], index: usize, time: &Rational) -> Self {
        let unit = |i: usize| [0, 1, 2].map(|k| Rational::from(u8::from(i == k)));
        let mut placement = Self { matrix: [0, 1, 2].map(unit), translation: [0, 1, 2].map(|_| Rational::ZERO) };
        let mut start = Rational::ZERO;
        for part in &parts[..index] {
            placement = placement.then(part, &Rational::ONE);
            start = rational(part.until);
        }
        let until = rational(parts[index].until);
        let s = (time - &start) / (&until - &start);
        placement.then(&parts[index], &s)
    }

    fn then(self, part: &MotionPiece, s: &Rational) -> Self {
        let q: [Rational; 4] =
            [0, 1, 2, 3].map(|k| rational(part.from[k]) + s * (rational(part.to[k]) - rational(part.from[k])));
        let [w, x, y, z] = &q;
        let square = q.iter().map(|c| c * c).fold(Rational::ZERO, |sum, c| sum + c);
        let two = Rational::from(2u8);
        let axis = [x, y, z];
        // the matrix of the cross product with the axis
        let skew = [[Rational::ZERO, -z, y.clone()], [z.clone(), Rational::ZERO, -x], [-y, x.clone(), Rational::ZERO]];
        let entry = |i: usize, j: usize| {
            let diagonal = if i == j { &square - &two * (&square - w * w) } else { Rational::ZERO };
            (diagonal + &two * axis[i] * axis[j] + &two * w * &skew[i][j]) / &square
        };
        let rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)));
        let point = part.axis_point.map(rational);
        let column = |j: usize| [0, 1, 2].map(|i| self.matrix[i][j].clone());
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot(&rotation[i], &column(j))));
        let off = [0, 1, 2].map(|k| &self.translation[k] - &point[k]);
        let translation = [0, 1, 2].map(|i| dot(&rotation[i], &off) + &point[i] + s * rational(part.translation[i]));
        Self { matrix, translation }
    }

    /// The image of a vector.
    pub fn turned(&self, v: [f64; 3]) -> [Rational; 3] {
        let v = v.map(rational);
        [0, 1, 2].map(|i| dot(&self.matrix[i], &v))
    }

    /// The image of a point.
    pub fn of(&self, x: [f64; 3]) -> [Rational; 3] {
        let turned = self.turned(x);
        [0, 1, 2].map(|i| &turned[i] + &self.translation[i])
    }
}

/// A direction as the placements turn it.
fn turned_with(placements: [&Placement; 2], direction: &SeparatingDirection) -> [Rational; 3] {
    match direction {
        SeparatingDirection::Space(u) => u.map(rational),
        SeparatingDirection::First(u) => placements[0].turned(*u),
        SeparatingDirection::Second(u) => placements[1].turned(*u),
        SeparatingDirection::Edges([e, f]) => {
            let (e, f) = (placements[0].turned(*e), placements[1].turned(*f));
            cross(&e, &f)
        }
    }
}

/// u · (c_b − c_a) − Σ |u · g| over the generators of both bodies as they are placed.
pub fn gap(bodies: [&Zonotope<3>; 2], placements: [&Placement; 2], direction: &SeparatingDirection) -> Rational {
    let u = turned_with(placements, direction);
    let [from, to] = [0, 1].map(|i| placements[i].of(bodies[i].center()));
    let apart = [0, 1, 2].map(|k| &to[k] - &from[k]);
    let reach = |i: usize| {
        let along = bodies[i].generators().iter().map(|g| dot(&u, &placements[i].turned(*g)));
        along.map(|c| if c < Rational::ZERO { -c } else { c }).fold(Rational::ZERO, |sum, c| sum + c)
    };
    dot(&u, &apart) - reach(0) - reach(1)
}

/// The least u · y − u · x over the corners x of the first hull and y of the second as they are placed, where both have
/// corners.
pub fn gap_of_corners(
    corners: [&[[f64; 3]]; 2],
    placements: [&Placement; 2],
    direction: &SeparatingDirection,
) -> Option<Rational> {
    let u = turned_with(placements, direction);
    let along = |i: usize| corners[i].iter().map(|corner| dot(&u, &placements[i].of(*corner))).collect::<Vec<_>>();
    let (farthest, nearest) = (along(0).into_iter().max()?, along(1).into_iter().min()?);
    Some(nearest - farthest)
}
