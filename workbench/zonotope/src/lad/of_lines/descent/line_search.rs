//! The exact minimum of the objective along one line, by weighted medians and exact passes.
//!
//! Along a line the objective is convex and piecewise linear with a breakpoint where each other line crosses. The
//! breakpoint at which the slope changes sign is a weighted median of the crossings. Floating point proposes it; one
//! exact pass over the lines at the proposed crossing gives the exact slopes on both sides. If they do not bracket zero, the
//! same pass tells exactly which crossings lie on the better side, and the search goes on among those: correct for every
//! input, and with one pass whenever floating point was right.

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::arrangement::ExactLine;
use crate::lad::of_lines::subproblem::instance::{Instance, Surroundings};
use crate::lad::of_lines::subproblem::vertex::Vertex;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::{Operation, Tally};

/// A line to search along: any line of the plane, and its index if it is one of the instance.
#[derive(Debug, Clone)]
pub(crate) struct SearchLine {
    /// Made when a decision needs it.
    exact: OnceCell<ExactLine>,
    pub(crate) index: Option<u32>,
    normal: [f64; 2],
    offset: f64,
}

/// Where a search along a line ended.
#[derive(Debug)]
pub(crate) enum LineMinimum {
    /// At the crossing with a line of the instance; the surroundings hold what was read there.
    At(Box<Vertex>),
    /// The objective falls without bound forward (true) or backward along the line.
    Unbounded { forward: bool },
    /// No line of the instance crosses, and the objective is constant along the line.
    Flat,
}

/// A crossing with a line of the instance.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// The position along the line, as good as floating point gives it.
    position: f64,
    /// |normal × direction|, rounded: half of what the slope gains there.
    weight: f64,
    line: u32,
    /// The exact sign of the rate at which the line's value grows along the direction.
    rate_sign: i8,
}

impl SearchLine {
    /// A line of the instance.
    pub(crate) fn of(instance: &Instance, line: u32) -> Self {
        let (normal, offset) = (instance.normal(line), instance.offset(line));
        Self { exact: OnceCell::new(), index: Some(line), normal, offset }
    }

    /// A line that need not be one of the instance, scaled to a normal of magnitude about 1.
    pub(crate) fn free(exact: ExactLine) -> Self {
        let exact = exact.normalized();
        let normal = [exact.normal[0].to_f64(), exact.normal[1].to_f64()];
        let offset = exact.offset.to_f64();
        Self { exact: OnceCell::from(exact), index: None, normal, offset }
    }

    /// The line, exactly; it was made for this instance.
    pub(crate) fn exact(&self, instance: &Instance) -> &ExactLine {
        let of_instance = || instance.exact_line(self.index.expect("a free line is exact from the start"));
        self.exact.get_or_init(of_instance)
    }

    fn direction(&self) -> [f64; 2] {
        [-self.normal[1], self.normal[0]]
    }

    /// The point of the line nearest to the origin, rounded: positions are measured from it.
    fn foot(&self) -> [f64; 2] {
        let [x, y] = self.normal;
        let scale = x.abs().max(y.abs());
        let (x, y) = (x / scale, y / scale);
        let factor = -(self.offset / scale) / (x * x + y * y);
        [factor * x, factor * y]
    }

    /// The exact sign of the slope of the objective when leaving a point of the line forward (or backward).
    pub(crate) fn slope_sign(&self, instance: &Instance, around: &Surroundings, forward: bool) -> Ordering {
        let sense = if forward { 1.0 } else { -1.0 };
        let direction = self.direction().map(|d| sense * d);
        let slope = |g: [f64; 2]| g[0] * direction[0] + g[1] * direction[1];
        let size = direction[0].abs() + direction[1].abs();
        let through: f64 = around.through.iter().map(|&k| slope(instance.normal(k)).abs()).sum();
        let value = slope(around.gradient) + through;
        let terms = (around.through.len() + 16) as f64;
        let normals: f64 = around.through.iter().map(|&k| instance.normal(k).map(f64::abs).iter().sum::<f64>()).sum();
        let gradient = around.gradient[0].abs() + around.gradient[1].abs();
        let error = size * (2.0 * around.gradient_error + terms * UNIT * (gradient + normals)) + UNDERFLOW;
        if value.abs() > error {
            return value.total_cmp(&0.0);
        }
        self.exact_slope(instance, around, forward).sign()
    }

    fn exact_slope(&self, instance: &Instance, around: &Surroundings, forward: bool) -> Dyadic {
        let direction = self.exact(instance).direction();
        let slope = |g: &[Dyadic; 2]| &g[0] * &direction[0] + &g[1] * &direction[1];
        let along = slope(&instance.exact_gradient(&around.signs));
        let along = if forward { along } else { -along };
        around.through.iter().fold(along, |sum, &k| sum + slope(&instance.exact_line(k).normal).abs())
    }

    /// The exact minimum of the objective on this line; `around` is left at it.
    pub(crate) fn minimize(
        &self,
        instance: &Instance,
        around: &mut Surroundings,
        tally: &mut impl Tally,
    ) -> LineMinimum {
        tally.add(Operation::SearchStep, 1);
        let mut crossings = self.crossings(instance, tally);
        if crossings.is_empty() {
            return self.minimum_without_crossings(instance);
        }
        let mut candidates = &mut crossings[..];
        let mut forward = true;
        let mut slope_to_gain = {
            let [x, y] = self.direction();
            let start =
                instance.linear[0] * x + instance.linear[1] * y - candidates.iter().map(|c| c.weight).sum::<f64>();
            -start / 2.0
        };
        loop {
            tally.add(Operation::Comparison, 2 * candidates.len() as u64);
            let order = |a: &Crossing, b: &Crossing| {
                let order = a.position.total_cmp(&b.position).then(a.line.cmp(&b.line));
                if forward { order } else { order.reverse() }
            };
            let pivot = *weighted_select(candidates, slope_to_gain, order, |c| c.weight);
            let vertex =
                Vertex::new(self.exact(instance), &instance.exact_line(pivot.line), [self.index, Some(pivot.line)]);
            instance.read_at(&vertex, around, tally);
            forward = if self.slope_sign(instance, around, true).is_lt() {
                true
            } else if self.slope_sign(instance, around, false).is_lt() {
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
            slope_to_gain = self.rounded_slope(instance, around, forward) / -2.0;
        }
    }

    fn rounded_slope(&self, instance: &Instance, around: &Surroundings, forward: bool) -> f64 {
        let sense = if forward { 1.0 } else { -1.0 };
        let [x, y] = self.direction();
        let through: f64 = around
            .through
            .iter()
            .map(|&k| {
                let [a, b] = instance.normal(k);
                (a * x + b * y).abs()
            })
            .sum();
        sense * (around.gradient[0] * x + around.gradient[1] * y) + through
    }

    fn minimum_without_crossings(&self, instance: &Instance) -> LineMinimum {
        let [dx, dy] = self.exact(instance).direction();
        let [cx, cy] = instance.exact_linear();
        match (cx * &dx + cy * &dy).sign() {
            Ordering::Less => LineMinimum::Unbounded { forward: true },
            Ordering::Greater => LineMinimum::Unbounded { forward: false },
            Ordering::Equal => LineMinimum::Flat,
        }
    }

    fn crossings(&self, instance: &Instance, tally: &mut impl Tally) -> Vec<Crossing> {
        let n = instance.len();
        instance.count_pass(tally);
        let ([dx, dy], [fx, fy]) = (self.direction(), self.foot());
        let exact_rate = instance.exact_rates(|| self.exact(instance).direction());
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
        instance.lines.each_block(|start, block| {
            for i in 0..block.len() {
                cross((start + i) as u32, block.row(i));
            }
        });
        crossings
    }
}

/// The item at which the weights, added up in the given order, reach `target`; the last one if they never do. Of at least one item;
/// expected O(n); the order of `items` is left changed.
pub(crate) fn weighted_select<T>(
    items: &mut [T],
    target: f64,
    order: impl Fn(&T, &T) -> Ordering,
    weight: impl Fn(&T) -> f64,
) -> &T {
    let mut range = items;
    let mut missing = target;
    while range.len() > 1 {
        let middle = (range.len() - 1) / 2;
        range.select_nth_unstable_by(middle, &order);
        let below: f64 = range[..=middle].iter().map(&weight).sum();
        if below >= missing {
            range = &mut range[..=middle];
        } else {
            missing -= below;
            range = &mut range[middle + 1..];
        }
    }
    &range[0]
}

/// Moves the crossings that satisfy a predicate to the front; returns how many they are.
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
