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

/// A crossing with a line of the subproblem.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// The rounded position along the line.
    position: f64,
    /// The rounded product |normal × direction|, half of what the slope gains at the crossing.
    weight: f64,
    line: u32,
    /// The exact sign of the rate at which the line's value grows along the direction.
    rate_sign: i8,
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
        if crossings.is_empty() {
            return self.minimum_without_crossings(subproblem);
        }
        let mut candidates = &mut crossings[..];
        let mut forward = true;
        let mut slope_to_gain = {
            let [x, y] = self.direction();
            let start =
                subproblem.linear[0] * x + subproblem.linear[1] * y - candidates.iter().map(|c| c.weight).sum::<f64>();
            -start / 2.0
        };
        loop {
            tally.add(Operation::Comparison, 2 * candidates.len() as u64);
            let order = |a: &Crossing, b: &Crossing| {
                let order = a.position.total_cmp(&b.position).then(a.line.cmp(&b.line));
                if forward { order } else { order.reverse() }
            };
            let pivot = *weighted_median(candidates, slope_to_gain, order, |c| c.weight).expect("candidates are left");
            let own = || self.exact(subproblem).clone();
            let vertex = subproblem.meeting_point(self.index, own, pivot.line);
            subproblem.read_at(&vertex, around, tally);
            forward = if self.slope_sign(subproblem, around, true).is_lt() {
                true
            } else if self.slope_sign(subproblem, around, false).is_lt() {
                false
            } else {
                return LineMinimum::At(Box::new(vertex));
            };
            let better = partition(candidates, |c| {
                let ahead = around.signs[c.line as usize] * c.rate_sign;
                if forward { ahead < 0 } else { ahead > 0 }
            });
            candidates = &mut candidates[..better];
            if candidates.is_empty() {
                return LineMinimum::Unbounded { forward };
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
    fn crossings(&self, subproblem: &Subproblem, tally: &mut impl Tally) -> Vec<Crossing> {
        let n = subproblem.len();
        subproblem.count_pass(tally);
        let ([dx, dy], [fx, fy]) = (self.direction(), self.foot());
        let exact_rate = subproblem.exact_rates(|| self.exact(subproblem).direction());
        let mut crossings = Vec::with_capacity(n);
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
            crossings.push(Crossing {
                position: if position.is_nan() { 0.0 } else { position },
                weight: rate.abs(),
                line,
                rate_sign,
            });
        };
        subproblem.lines.each_block(|start, block| {
            for i in 0..block.len() {
                cross((start + i) as u32, block.row(i));
            }
        });
        crossings
    }
}

/// Moves the crossings that satisfy a predicate to the front, and returns their number.
fn partition(crossings: &mut [Crossing], keep: impl Fn(&Crossing) -> bool) -> usize {
    let mut kept = 0;
    for i in 0..crossings.len() {
        if keep(&crossings[i]) {
            crossings.swap(kept, i);
            kept += 1;
        }
    }
    kept
}
