//! The exact coefficients of the lines, made when a decision needs them.

use std::cmp::Ordering;
use std::fmt::Debug;

use crate::arrangement::ExactLine;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;

/// A source of exact lines.
///
/// Only [`line`](Self::line) must be there. The other operations let a source answer at once what it knows of all its
/// lines, where exact arithmetic line by line would take most of the time: bisectors of a polygon, say, whose normals
/// sum to zero.
pub(crate) trait ExactLines: Debug + Sync {
    /// The exact line at a position.
    fn line(&self, position: usize) -> ExactLine;

    /// Whether the normals of all lines are known to sum to zero.
    fn normals_sum_to_zero(&self) -> bool {
        false
    }

    /// A point that may lie on one side of all lines, if the normals are known to sum to zero: then the objective is
    /// least there, as the sum of all values is the same everywhere.
    fn balanced_center(&self) -> Option<[f64; 2]> {
        None
    }

    /// A test that is true only of lines that pass through the given point; where it is false, the line may pass or
    /// not.
    fn certainly_passing(&self, _point: [f64; 2]) -> Box<dyn Fn(usize) -> bool + '_> {
        Box::new(|_| false)
    }

    /// A filter for the sign of a line's value at a point in homogeneous coordinates, W ≥ 0, by arithmetic between
    /// doubles and exact numbers; `None` where it leaves the sign open.
    fn certain_signs(&self, _point: &[Dyadic; 3]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        Box::new(|_| None)
    }

    /// The sign of the cross product of the normals of two lines, where it takes no exact arithmetic.
    fn certain_cross_sign(&self, _first: usize, _second: usize) -> Option<Ordering> {
        None
    }

    /// The same filter for a point known by pairs of doubles; only a source that knows
    /// [common points](Self::meeting_point) is asked.
    fn certain_sides(&self, _place: [BoundedDoubleDouble; 2]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        Box::new(|_| None)
    }

    /// The common point of two lines that are not parallel by pairs of doubles; `None` unless the larger double of each
    /// is within 4 UNIT of the exact coordinate, or [`UNDERFLOW`](crate::numeric::tolerance::UNDERFLOW).
    fn meeting_point(&self, _first: usize, _second: usize) -> Option<[BoundedDoubleDouble; 2]> {
        None
    }

    /// The value of a line at a point known by pairs of doubles.
    fn value_near(&self, _position: usize, _place: &[BoundedDoubleDouble; 2]) -> Option<BoundedDoubleDouble> {
        None
    }

    /// The sign of the rate at which Σ sign · normal · x over all lines grows along one of them, forward, by less than
    /// exact arithmetic; `None` where it leaves the sign open.
    fn certain_rate(&self, _signs: &[i8], _along: usize) -> Option<Ordering> {
        None
    }

    /// The exact sum Σ sign · normal over the given positions.
    fn signed_normal_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> [Dyadic; 2] {
        let mut sum = [Dyadic::zero(), Dyadic::zero()];
        for (position, sign) in terms {
            let [x, y] = self.line(position).normal;
            let [sx, sy] = sum;
            sum = match sign {
                0 => [sx, sy],
                1.. => [sx + x, sy + y],
                ..=-1 => [sx - x, sy - y],
            };
        }
        sum
    }
}
