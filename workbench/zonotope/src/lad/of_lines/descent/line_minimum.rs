//! The exact minimum of the objective along one line, by weighted medians and exact passes.
//!
//! Along a line the objective is convex and piecewise linear with a breakpoint where each other line crosses. The
//! breakpoint at which the slope changes sign is a weighted median of the crossings. Floating point proposes it; one
//! exact pass over the lines at the proposed crossing gives the exact slopes on both sides. If they do not bracket
//! zero, the same pass tells exactly which crossings lie on the better side, and the search goes on among those:
//! correct for every input, and with one pass whenever floating point was right.

use std::cmp::Ordering;

use super::search_line::SearchLine;
use crate::lad::of_lines::subproblem::{Subdifferential, Subproblem, Vertex};
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::numeric::weighted_median::weighted_median;
use crate::tally::{Operation, Tally};

/// The outcome of a search along a line.
#[derive(Debug)]
pub(crate) enum LineMinimum {
    /// The minimum is at the crossing with a line of the subproblem, whose subdifferential was read last.
    At(Box<Vertex>),
    /// The objective falls without bound forward (true) or backward along the line.
    Unbounded { forward: bool },
    /// No line of the subproblem crosses, and the objective is constant along the line.
    Flat,
}

/// Crossings with lines of the subproblem, in the order of these lines, in columns.
#[derive(Debug)]
struct Crossings {
    /// The rounded positions along the line.
    positions: Vec<f64>,
    /// The rounded products |normal × direction|, half of what the slope gains at each crossing.
    weights: Vec<f64>,
    lines: Vec<u32>,
    /// The exact signs of the rates at which the lines' values grow along the direction.
    rate_signs: Vec<i8>,
}

impl Crossings {
    fn with_capacity(capacity: usize) -> Self {
        Self {
            positions: Vec::with_capacity(capacity),
            weights: Vec::with_capacity(capacity),
            lines: Vec::with_capacity(capacity),
            rate_signs: Vec::with_capacity(capacity),
        }
    }

    fn len(&self) -> usize {
        self.lines.len()
    }

    fn push(&mut self, position: f64, weight: f64, line: u32, rate_sign: i8) {
        self.positions.push(position);
        self.weights.push(weight);
        self.lines.push(line);
        self.rate_signs.push(rate_sign);
    }

    /// Puts the crossings in the order of a search the other way.
    fn reverse(&mut self) {
        self.positions.reverse();
        self.positions.iter_mut().for_each(|position| *position = -*position);
        self.weights.reverse();
        self.lines.reverse();
        self.rate_signs.reverse();
    }

    /// Keeps the crossings with a line and a sign of its rate that satisfy a predicate, in their order.
    fn retain(&mut self, keep: impl Fn(u32, i8) -> bool) {
        let mut kept = 0;
        for i in 0..self.len() {
            self.positions[kept] = self.positions[i];
            self.weights[kept] = self.weights[i];
            (self.lines[kept], self.rate_signs[kept]) = (self.lines[i], self.rate_signs[i]);
            kept += usize::from(keep(self.lines[i], self.rate_signs[i]));
        }
        self.positions.truncate(kept);
        self.weights.truncate(kept);
        self.lines.truncate(kept);
        self.rate_signs.truncate(kept);
    }
}

impl SearchLine {
    /// The exact minimum of the objective on this line; `around` is left at the subdifferential there.
    pub(crate) fn minimize(
        &self,
        subproblem: &Subproblem,
        around: &mut Subdifferential,
        tally: &mut impl Tally,
    ) -> LineMinimum {
        tally.add(Operation::SearchStep, 1);
        let mut crossings = self.crossings(subproblem, tally);
        if crossings.len() == 0 {
            return self.minimum_without_crossings(subproblem);
        }
        let mut forward = true;
        let mut slope_to_gain = {
            let [x, y] = self.direction();
            let start = subproblem.linear[0] * x + subproblem.linear[1] * y - crossings.weights.iter().sum::<f64>();
            -start / 2.0
        };
        loop {
            tally.add(Operation::Comparison, 2 * crossings.len() as u64);
            let median = weighted_median(&crossings.positions, &crossings.weights, slope_to_gain);
            let pivot = crossings.lines[median.expect("candidates are left")];
            let own = || self.exact(subproblem).clone();
            let vertex = subproblem.meeting_point(self.index, own, pivot);
            subproblem.read_at(&vertex, around, tally);
            let was_forward = forward;
            forward = if self.slope_sign(subproblem, around, true).is_lt() {
                true
            } else if self.slope_sign(subproblem, around, false).is_lt() {
                false
            } else {
                return LineMinimum::At(Box::new(vertex));
            };
            crossings.retain(|line, rate_sign| {
                let ahead = around.signs[line as usize] * rate_sign;
                if forward { ahead < 0 } else { ahead > 0 }
            });
            if crossings.len() == 0 {
                return LineMinimum::Unbounded { forward };
            }
            if forward != was_forward {
                crossings.reverse();
            }
            slope_to_gain = self.rounded_slope(subproblem, around, forward) / -2.0;
        }
    }

    /// The minimum on a line that no line of the subproblem crosses: the objective is linear on it.
    fn minimum_without_crossings(&self, subproblem: &Subproblem) -> LineMinimum {
        let [dx, dy] = self.exact(subproblem).direction();
        let [cx, cy] = subproblem.exact_linear();
        match (cx * &dx + cy * &dy).sign() {
            Ordering::Less => LineMinimum::Unbounded { forward: true },
            Ordering::Greater => LineMinimum::Unbounded { forward: false },
            Ordering::Equal => LineMinimum::Flat,
        }
    }

    /// The crossings with all lines of the subproblem that are not parallel. One pass.
    fn crossings(&self, subproblem: &Subproblem, tally: &mut impl Tally) -> Crossings {
        let n = subproblem.len();
        subproblem.count_pass(tally);
        let ([dx, dy], [fx, fy]) = (self.direction(), self.foot());
        let exact_rate = subproblem.exact_rates(|| self.exact(subproblem).direction());
        let mut crossings = Crossings::with_capacity(n);
        let mut cross = |line: u32, [x, y, b]: [f64; 3]| {
            let (left, right) = (x * dx, y * dy);
            let rate = left + right;
            let bound = 16.0 * UNIT * (left.abs() + right.abs()) + UNDERFLOW;
            let rate_sign = if rate > bound {
                1
            } else if rate < -bound {
                -1
            } else if self.index == Some(line) {
                0
            } else {
                tally.add(Operation::ExactFallback, 1);
                exact_rate(line)
            };
            if rate_sign == 0 {
                return;
            }
            let position = -(x * fx + y * fy + b) / rate;
            crossings.push(if position.is_nan() { 0.0 } else { position }, rate.abs(), line, rate_sign);
        };
        subproblem.lines.each_block(|start, block| {
            for i in 0..block.len() {
                cross((start + i) as u32, block.row(i));
            }
        });
        crossings
    }
}
