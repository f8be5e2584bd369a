//! A part of a problem: some of its lines, and a linear term that stands for the others.
//!
//! The same search serves the whole problem, a sample of it, the few lines that cross a cell (all others are summed
//! into the linear term) and the lines through one degenerate vertex. Exact coefficients are looked up in the problem
//! when a floating-point filter cannot decide.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::rc::Rc;

use super::exact_linear::ExactLinear;
use super::vertex::Vertex;
use crate::arrangement::ExactLine;
use crate::lad::of_lines::input::LadProblem;
use crate::lad::of_lines::input::rounded_lines::{GatheredLines, LineError, RoundedLines};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::{Operation, Tally};

/// Some lines of a problem with a linear term.
#[derive(Debug)]
pub(crate) struct Subproblem<'p> {
    problem: &'p LadProblem<'p>,
    pub(crate) lines: RoundedLines<'p>,
    /// The position in the problem of each line here; all lines in their order when absent.
    members: Option<Rc<[u32]>>,
    /// Whether the rounded offsets stand for themselves rather than for the problem's.
    own_offsets: bool,
    /// Whether only the place of the optimum is asked for, not its coefficients.
    asks_place_only: bool,
    /// The rounded linear term.
    pub(crate) linear: [f64; 2],
    /// A bound on the error of each coordinate of `linear`.
    pub(crate) linear_error: f64,
    linear_source: ExactLinear,
    exact_linear: OnceCell<[Dyadic; 2]>,
}

impl<'p> Subproblem<'p> {
    /// The whole problem.
    pub(crate) fn whole(problem: &'p LadProblem<'p>) -> Self {
        let linear = problem.approximate_linear();
        let source = ExactLinear::known(problem.linear.clone());
        Self::new(problem, problem.rounded(), None, linear, source)
    }

    /// The same lines where only the place of the optimum is asked for, not its coefficients.
    pub(crate) fn without_coefficients(self) -> Self {
        Self { asks_place_only: true, ..self }
    }

    /// Some lines of the subproblem, with a linear term of their own.
    pub(crate) fn selection(&self, lines: &[u32], linear: [f64; 2], source: ExactLinear) -> Self {
        let mut rows = GatheredLines::with_capacity(lines.len());
        for &line in lines {
            let (row, error) = self.lines.row(line as usize);
            rows.push(row, error);
        }
        self.part(lines, rows, linear, source)
    }

    /// Some lines of the subproblem, given their coefficients.
    fn part(&self, lines: &[u32], rows: GatheredLines, linear: [f64; 2], source: ExactLinear) -> Self {
        let mut part = Self::new(self.problem, rows.into_lines(), Some(self.positions(lines)), linear, source);
        part.own_offsets = self.own_offsets;
        part.asks_place_only = self.asks_place_only;
        part
    }

    /// Some lines of the subproblem that stand for all of them, with a linear term in proportion.
    pub(crate) fn sample(&self, lines: &[u32], linear: [f64; 2]) -> Self {
        let source = ExactLinear::known(linear.map(Dyadic::from_f64));
        Self { asks_place_only: true, ..self.selection(lines, linear, source) }
    }

    /// Some lines of the subproblem, given their coefficients, in the same objective: the other lines have fixed signs,
    /// and their signed normals sum to `fixed_sum` within `fixed_error`.
    pub(crate) fn remainder(
        &self,
        lines: &[u32],
        rows: GatheredLines,
        signs: Vec<i8>,
        fixed_sum: [f64; 2],
        fixed_error: f64,
    ) -> Self {
        let source = self.linear_source.with_fixed_signs(self.members.clone(), signs);
        let linear = [self.linear[0] + fixed_sum[0], self.linear[1] + fixed_sum[1]];
        let mut remainder = self.part(lines, rows, linear, source);
        remainder.linear_error += self.linear_error + fixed_error;
        remainder
    }

    /// The lines through a vertex, moved apart to the given offsets. All other lines have the given signs, and their
    /// signed normals with the linear term sum to `gradient` within `gradient_error`.
    pub(crate) fn moved_apart(
        &self,
        lines: &[u32],
        offsets: Vec<f64>,
        signs: Vec<i8>,
        gradient: [f64; 2],
        gradient_error: f64,
    ) -> Self {
        let mut rows = GatheredLines::with_capacity(lines.len());
        for (&line, offset) in lines.iter().zip(offsets) {
            let [x, y] = self.normal(line);
            rows.push([x, y, offset], LineError::default());
        }
        let source = self.linear_source.with_fixed_signs(self.members.clone(), signs);
        let mut moved = Self { own_offsets: true, ..self.part(lines, rows, gradient, source) };
        moved.linear_error += gradient_error;
        moved
    }

    fn new(
        problem: &'p LadProblem<'p>,
        lines: RoundedLines<'p>,
        members: Option<Rc<[u32]>>,
        linear: [f64; 2],
        linear_source: ExactLinear,
    ) -> Self {
        Self {
            problem,
            lines,
            members,
            own_offsets: false,
            asks_place_only: false,
            linear,
            linear_error: 8.0 * UNIT * (linear[0].abs() + linear[1].abs()) + UNDERFLOW,
            linear_source,
            exact_linear: OnceCell::new(),
        }
    }

    fn positions(&self, lines: &[u32]) -> Rc<[u32]> {
        lines.iter().map(|&line| self.position(line) as u32).collect()
    }

    /// The fixed signs of the lines that this remainder leaves out, one for each line of the subproblem from which it
    /// was taken.
    pub(crate) fn fixed_signs(&self) -> &[i8] {
        self.linear_source.last_signs()
    }

    pub(crate) fn len(&self) -> usize {
        self.lines.len()
    }

    /// Counts one evaluation of every line.
    pub(crate) fn count_pass(&self, tally: &mut impl Tally) {
        let operation = if self.members.is_none() { Operation::LineEvaluation } else { Operation::PartEvaluation };
        tally.add(operation, self.len() as u64);
    }

    /// The position in the problem of a line of the subproblem.
    pub(crate) fn position(&self, line: u32) -> usize {
        self.members.as_ref().map_or(line, |members| members[line as usize]) as usize
    }

    pub(crate) fn normal(&self, line: u32) -> [f64; 2] {
        let ([x, y, _], _) = self.lines.row(line as usize);
        [x, y]
    }

    pub(crate) fn offset(&self, line: u32) -> f64 {
        let ([_, _, offset], _) = self.lines.row(line as usize);
        offset
    }

    pub(crate) fn exact_line(&self, line: u32) -> ExactLine {
        let mut exact = self.problem.exact.line(self.position(line));
        if self.own_offsets {
            exact.offset = Dyadic::from_f64(self.offset(line));
        }
        exact
    }

    pub(crate) fn exact_linear(&self) -> &[Dyadic; 2] {
        self.exact_linear.get_or_init(|| self.linear_source.value(self.problem))
    }

    /// A direction in which the linear term certainly falls, if rounding leaves no doubt.
    ///
    /// For the rounded term r and an error of at most e a coordinate, linear · r ≥ |r|² − e |r|_1, which is positive if
    /// the largest coordinate of r exceeds 2 e.
    pub(crate) fn certain_descent(&self) -> Option<[f64; 2]> {
        let largest = self.linear[0].abs().max(self.linear[1].abs());
        (largest > 4.0 * self.linear_error).then(|| self.linear.map(|v| -v))
    }

    /// linear + Σ sign · normal, exactly.
    pub(crate) fn exact_gradient(&self, signs: &[i8]) -> [Dyadic; 2] {
        let signed = (0..).zip(signs).filter(|(_, sign)| **sign != 0);
        let [x, y] = self.exact_signed_sum(signed.map(|(line, &sign)| (line, sign)));
        let [cx, cy] = self.exact_linear();
        [cx + &x, cy + &y]
    }

    /// Σ sign · normal over some lines, exactly.
    pub(crate) fn exact_signed_sum(&self, terms: impl Iterator<Item = (u32, i8)>) -> [Dyadic; 2] {
        let mut terms = terms.map(|(line, sign)| (self.position(line), sign));
        self.problem.exact.signed_normal_sum(&mut terms)
    }

    /// The common point of a line, which is `line` here if it is one of the subproblem at all and is given exactly
    /// where that is needed, and another line of the subproblem.
    pub(crate) fn meeting_point(&self, line: Option<u32>, exact: impl Fn() -> ExactLine, other: u32) -> Vertex {
        if let Some(line) = line.filter(|_| !self.own_offsets) {
            let positions = [line, other].map(|line| self.position(line));
            if let Some(place) = self.problem.exact.meeting_point(positions[0], positions[1]) {
                return Vertex::meeting_near(place, positions, [line, other]);
            }
        }
        Vertex::meeting(&exact(), &self.exact_line(other), [line, Some(other)])
    }

    /// The sign of linear + Σ sign · normal along a line, where the source of the lines tells it at once.
    pub(crate) fn certain_rate(&self, signs: &[i8], along: u32) -> Option<Ordering> {
        if self.asks_place_only || !self.linear_source.is_of_signs_alone() {
            return None;
        }
        if self.members.is_none() {
            return self.problem.exact.certain_rate(signs, along as usize);
        }
        let mut all = vec![0; self.problem.len()];
        self.linear_source.add_signs(&mut all);
        for (line, &sign) in signs.iter().enumerate() {
            all[self.position(line as u32)] = sign;
        }
        self.problem.exact.certain_rate(&all, self.position(along))
    }

    /// The exact side of a line on which a vertex lies, as a function of the line.
    pub(super) fn exact_sides<'a>(&'a self, vertex: &'a Vertex) -> impl Fn(u32) -> i8 + 'a {
        let (passing, signs) = (OnceCell::new(), OnceCell::new());
        move |line| {
            let point = || if self.own_offsets { None } else { vertex.as_doubles(self.problem) };
            let passing = passing.get_or_init(|| point().map(|point| self.problem.exact.certainly_passing(point)));
            if passing.as_ref().is_some_and(|passes| passes(self.position(line))) {
                return 0;
            }
            let known = || match vertex.place {
                Some(place) => self.problem.exact.certain_sides(place),
                None => self.problem.exact.certain_signs(vertex.exact(self.problem)),
            };
            let known = if self.own_offsets { None } else { signs.get_or_init(known)(self.position(line)) };
            known.unwrap_or_else(|| vertex.exact_side(self.problem, &self.exact_line(line)))
        }
    }

    /// Whether there is no linear term and coefficients are not asked for, or may all be 1: the normals are known to
    /// sum to zero.
    pub(crate) fn is_balanced(&self) -> bool {
        let all_cancel = || self.members.is_none() && self.problem.exact.normals_sum_to_zero();
        (self.asks_place_only || all_cancel()) && self.exact_linear().iter().all(Dyadic::is_zero)
    }

    /// A point that is expected to be near the optimum, where this is the whole of a problem without a linear term
    /// whose normals sum to zero.
    pub(crate) fn balanced_center(&self) -> Option<[f64; 2]> {
        if self.members.is_none() && self.is_balanced() { self.problem.exact.balanced_center() } else { None }
    }

    /// Whether only the place of the optimum is asked for, not its coefficients.
    pub(crate) fn asks_place_only(&self) -> bool {
        self.asks_place_only
    }

    /// Whether the normal of a line is exactly zero.
    pub(crate) fn has_zero_normal(&self, line: u32) -> bool {
        self.normal(line) == [0.0, 0.0] && self.exact_line(line).normal.iter().all(Dyadic::is_zero)
    }

    /// The exact sign of the rate at which a line's value grows along a direction, as a function of the line.
    pub(crate) fn exact_rates<'a>(&'a self, direction: impl Fn() -> [Dyadic; 2] + 'a) -> impl Fn(u32) -> i8 + 'a {
        let known = OnceCell::new();
        move |line| {
            let (direction, signs) = known.get_or_init(|| {
                let [dx, dy] = direction();
                let at_infinity = [dx, dy, Dyadic::zero()];
                let signs = self.problem.exact.certain_signs(&at_infinity);
                (at_infinity, signs)
            });
            let exact = || self.exact_line(line).evaluate(direction).sign() as i8;
            signs(self.position(line)).unwrap_or_else(exact)
        }
    }

    /// A line nearest to a point in rounded arithmetic; `None` if there are no lines with a normal.
    pub(crate) fn nearest_line(&self, [px, py]: [f64; 2], tally: &mut impl Tally) -> Option<u32> {
        self.count_pass(tally);
        let mut nearest = None;
        let mut least = f64::INFINITY;
        self.lines.each_block(|start, block| {
            for line in 0..block.len() {
                let [x, y, b] = block.row(line);
                let value = x * px + y * py + b;
                let squared_distance = value * value / (x * x + y * y);
                if squared_distance < least {
                    (nearest, least) = (Some((start + line) as u32), squared_distance);
                }
            }
        });
        nearest
    }

    /// The sign of the cross product of the normals of two lines.
    pub(crate) fn cross_sign(&self, first: u32, second: u32) -> Ordering {
        if first == second {
            return Ordering::Equal;
        }
        let ([a, b], [c, d]) = (self.normal(first), self.normal(second));
        let (left, right) = (a * d, b * c);
        if (left - right).abs() > 8.0 * UNIT * (left.abs() + right.abs()) + UNDERFLOW {
            return (left - right).total_cmp(&0.0);
        }
        if let Some(sign) = self.problem.exact.certain_cross_sign(self.position(first), self.position(second)) {
            return sign;
        }
        let ([a, b], [c, d]) = (self.exact_line(first).normal, self.exact_line(second).normal);
        (a * d).cmp(&(b * c))
    }
}
