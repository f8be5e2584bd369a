//! The exact coefficients of the lines, made when a decision needs them.

use std::cmp::Ordering;
use std::fmt::Debug;

use crate::arrangement::ExactLine;
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
