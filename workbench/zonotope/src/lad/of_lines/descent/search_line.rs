//! A line of the plane to search along, and the exact sign of the objective's slope on it.

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::arrangement::ExactLine;
use crate::lad::of_lines::subproblem::{Subdifferential, Subproblem};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// A line of the plane to search along, which need not be one of the subproblem's.
#[derive(Debug, Clone)]
pub(crate) struct SearchLine {
    /// The exact line, made when a decision needs it.
    exact: OnceCell<ExactLine>,
    /// The index of the line, where it is one of the subproblem's.
    pub(crate) index: Option<u32>,
    normal: [f64; 2],
    offset: f64,
}

impl SearchLine {
    /// A line of the subproblem.
    pub(crate) fn of(subproblem: &Subproblem, line: u32) -> Self {
        let (normal, offset) = (subproblem.normal(line), subproblem.offset(line));
        Self { exact: OnceCell::new(), index: Some(line), normal, offset }
    }

    /// A line that need not be one of the subproblem, scaled to a normal of magnitude about 1.
    pub(crate) fn free(exact: ExactLine) -> Self {
        let exact = exact.normalized();
        let normal = [exact.normal[0].to_f64(), exact.normal[1].to_f64()];
        let offset = exact.offset.to_f64();
        Self { exact: OnceCell::from(exact), index: None, normal, offset }
    }

    /// The exact line; the subproblem must be the one for which the search line was made.
    pub(crate) fn exact(&self, subproblem: &Subproblem) -> &ExactLine {
        let of_subproblem = || subproblem.exact_line(self.index.expect("a free line is exact from the start"));
        self.exact.get_or_init(of_subproblem)
    }

    /// The exact direction of the line, or the opposite one.
    pub(crate) fn oriented(&self, subproblem: &Subproblem, forward: bool) -> [Dyadic; 2] {
        let direction = self.exact(subproblem).direction();
        if forward { direction } else { direction.map(|v| -v) }
    }

    pub(super) fn direction(&self) -> [f64; 2] {
        [-self.normal[1], self.normal[0]]
    }

    /// The point of the line nearest to the origin, rounded: positions are measured from it.
    pub(super) fn foot(&self) -> [f64; 2] {
        let [x, y] = self.normal;
        let scale = x.abs().max(y.abs());
        let (x, y) = (x / scale, y / scale);
        let factor = -(self.offset / scale) / (x * x + y * y);
        [factor * x, factor * y]
    }

    /// The exact sign of the slope of the objective when leaving a point of the line forward (or backward).
    pub(crate) fn slope_sign(&self, subproblem: &Subproblem, around: &Subdifferential, forward: bool) -> Ordering {
        let sense = if forward { 1.0 } else { -1.0 };
        let direction = self.direction().map(|d| sense * d);
        let slope = |g: [f64; 2]| g[0] * direction[0] + g[1] * direction[1];
        let size = direction[0].abs() + direction[1].abs();
        let through: f64 = around.through.iter().map(|&k| slope(subproblem.normal(k)).abs()).sum();
        let value = slope(around.gradient) + through;
        let terms = (around.through.len() + 16) as f64;
        let normals: f64 = around.through.iter().map(|&k| subproblem.normal(k).map(f64::abs).iter().sum::<f64>()).sum();
        let gradient = around.gradient[0].abs() + around.gradient[1].abs();
        let error = size * (2.0 * around.gradient_error + terms * UNIT * (gradient + normals)) + UNDERFLOW;
        if value.abs() > error {
            return value.total_cmp(&0.0);
        }
        self.certain_slope(subproblem, around, forward)
            .unwrap_or_else(|| self.exact_slope(subproblem, around, forward).sign())
    }

    /// The sign of the slope, where the source of the lines tells the sign of a signed sum of normals along the line:
    /// each line through the point counts with the sign that it has ahead.
    fn certain_slope(&self, subproblem: &Subproblem, around: &Subdifferential, forward: bool) -> Option<Ordering> {
        let along = self.index?;
        let mut signs = around.signs.clone();
        for &line in &around.through {
            // The line's value grows along this one with the cross product of both normals.
            let ahead = subproblem.cross_sign(along, line);
            signs[line as usize] = if forward { ahead as i8 } else { -(ahead as i8) };
        }
        let rate = subproblem.certain_rate(&signs, along)?;
        Some(if forward { rate } else { rate.reverse() })
    }

    fn exact_slope(&self, subproblem: &Subproblem, around: &Subdifferential, forward: bool) -> Dyadic {
        let direction = self.exact(subproblem).direction();
        let slope = |g: &[Dyadic; 2]| &g[0] * &direction[0] + &g[1] * &direction[1];
        let along = slope(around.exact_gradient(subproblem));
        let along = if forward { along } else { -along };
        // each of the lines through the point adds its rate with the sign of that rate
        let rate_sign = subproblem.exact_rates(|| self.exact(subproblem).direction());
        along + slope(&subproblem.exact_signed_sum(around.through.iter().map(|&line| (line, rate_sign(line)))))
    }

    /// The rounded slope of the objective when leaving a point of the line forward (or backward).
    pub(super) fn rounded_slope(&self, subproblem: &Subproblem, around: &Subdifferential, forward: bool) -> f64 {
        let sense = if forward { 1.0 } else { -1.0 };
        let [x, y] = self.direction();
        let through: f64 = around
            .through
            .iter()
            .map(|&k| {
                let [a, b] = subproblem.normal(k);
                (a * x + b * y).abs()
            })
            .sum();
        sense * (around.gradient[0] * x + around.gradient[1] * y) + through
    }
}
