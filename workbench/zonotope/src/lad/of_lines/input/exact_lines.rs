//! Where the exact coefficients of the lines come from.

use std::fmt::Debug;

use super::problem::WeightedLine;
use crate::arrangement::ExactLine;
use crate::numeric::dyadic::Dyadic;

/// Exact lines, made when a decision needs them.
pub(crate) trait ExactLines: Debug + Sync {
    /// The exact line at a position.
    fn line(&self, position: usize) -> ExactLine;

    /// Whether the normals of all lines are known to sum to zero.
    fn normals_sum_to_zero(&self) -> bool {
        false
    }

    /// Tells of a line whether it passes through a point, where that is seen at a glance; `false` decides nothing.
    fn certainly_passing(&self, _point: [f64; 2]) -> Box<dyn Fn(usize) -> bool + '_> {
        Box::new(|_| false)
    }

    /// Tells the sign of a line's value at a point in homogeneous coordinates, W ≥ 0, where something between doubles and exact
    /// arithmetic does; `None` decides nothing.
    fn certain_signs(&self, _point: &[Dyadic; 3]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        Box::new(|_| None)
    }

    /// Σ sign · normal over the given positions, exactly.
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

/// Lines given as doubles, scaled by powers of two.
#[derive(Debug)]
pub(crate) struct Rows {
    pub(crate) lines: Vec<WeightedLine>,
    pub(crate) normal_scale: i64,
    pub(crate) offset_scale: i64,
}

impl ExactLines for Rows {
    fn line(&self, position: usize) -> ExactLine {
        let WeightedLine { normal, offset, weight } = self.lines[position];
        let weight = Dyadic::from_f64(weight);
        let times = |value: f64, scale: i64| (&weight * &Dyadic::from_f64(value)).scaled(-scale);
        ExactLine { normal: normal.map(|v| times(v, self.normal_scale)), offset: times(offset, self.offset_scale) }
    }
}
