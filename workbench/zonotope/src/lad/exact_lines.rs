//! Where the exact coefficients of the lines come from.

use std::fmt::Debug;

use super::problem::WeightedLine;
use crate::numeric::dyadic::Dyadic;

/// The exact line normal · x + offset = 0, with its weight multiplied in.
#[derive(Debug, Clone)]
pub struct ExactLine {
    /// The coefficients of x and y.
    pub normal: [Dyadic; 2],
    /// The constant coefficient.
    pub offset: Dyadic,
}

impl ExactLine {
    /// The homogeneous coordinates [X, Y, W] of the common point of two lines, W ≥ 0; W = 0 when they are parallel.
    pub fn meet(&self, other: &Self) -> [Dyadic; 3] {
        let ([a, b], c) = (&self.normal, &self.offset);
        let ([d, e], f) = (&other.normal, &other.offset);
        let point = [b * f - c * e, c * d - a * f, a * e - b * d];
        if point[2].sign().is_lt() { point.map(|v| -v) } else { point }
    }

    /// normal · [X, Y] + offset · W at a point in homogeneous coordinates: its sign is the point's side when W > 0.
    pub fn evaluate(&self, [x, y, w]: &[Dyadic; 3]) -> Dyadic {
        &self.normal[0] * x + &self.normal[1] * y + &self.offset * w
    }

    /// The same line, scaled by a power of two so that the larger coordinate of its normal is about 1.
    pub(crate) fn normalized(self) -> Self {
        let shift = self.normal.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        Self { normal: self.normal.map(|v| v.scaled(-shift)), offset: self.offset.scaled(-shift) }
    }

    /// The direction of the line: its normal turned by a quarter counter-clockwise.
    pub fn direction(&self) -> [Dyadic; 2] {
        [-self.normal[1].clone(), self.normal[0].clone()]
    }
}

/// Exact lines, made when a decision needs them.
pub(crate) trait ExactLines: Debug + Sync {
    /// The exact line at a position.
    fn line(&self, position: usize) -> ExactLine;

    /// Whether the normals of all lines are known to sum to zero.
    fn normals_sum_to_zero(&self) -> bool {
        false
    }

    /// Whether a line passes through a point, where that is seen at a glance; `false` decides nothing.
    fn certainly_passes(&self, _position: usize, _point: [f64; 2]) -> bool {
        false
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
