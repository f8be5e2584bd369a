//! A part of a problem that a method works on: some of the lines, and a linear term that stands for the others.
//!
//! The same search serves the whole problem, a sample of it, the few lines that cross a cell (all others are summed into
//! the linear term) and the lines through one degenerate vertex. Exact values are looked up in the problem when a
//! floating-point filter cannot decide.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::cmp::Ordering;
use std::rc::Rc;

use super::exact_lines::ExactLine;
use super::problem::{Columns, LadProblem, LineError};
use super::vertex::Vertex;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::{Operation, Tally};

/// Where the exact linear term of an instance comes from: a known vector, plus the normals of lines whose sign is fixed.
#[derive(Debug, Clone)]
pub(crate) struct ExactLinear {
    known: [Dyadic; 2],
    layers: Vec<Rc<FixedSigns>>,
}

/// One sign for each line of an instance, 0 for those that stay in the objective.
#[derive(Debug)]
struct FixedSigns {
    members: Option<Rc<[u32]>>,
    signs: Vec<i8>,
}

impl ExactLinear {
    /// A known vector.
    pub(crate) fn known(known: [Dyadic; 2]) -> Self {
        Self { known, layers: Vec::new() }
    }

    fn value(&self, problem: &LadProblem) -> [Dyadic; 2] {
        let [mut x, mut y] = self.known.clone();
        for FixedSigns { members, signs } in self.layers.iter().map(Rc::as_ref) {
            let position = |i: usize| members.as_ref().map_or(i, |m| m[i] as usize);
            let mut terms = signs.iter().enumerate().filter(|(_, s)| **s != 0).map(|(i, &s)| (position(i), s));
            let [dx, dy] = problem.exact.signed_normal_sum(&mut terms);
            (x, y) = (x + dx, y + dy);
        }
        [x, y]
    }
}

/// Some lines of a problem with a linear term.
#[derive(Debug)]
pub(crate) struct Instance<'p> {
    pub(crate) problem: &'p LadProblem<'p>,
    pub(crate) columns: Cow<'p, Columns>,
    /// The position in the problem of each line here; all lines in their order when absent.
    members: Option<Rc<[u32]>>,
    /// Whether the offsets of the columns stand for themselves rather than for the problem's.
    own_offsets: bool,
    pub(crate) error: LineError,
    pub(crate) linear: [f64; 2],
    linear_error: f64,
    linear_source: ExactLinear,
    exact_linear: OnceCell<[Dyadic; 2]>,
    magnitude: OnceCell<f64>,
}

/// What is known around a vertex: on which side of each line it lies, the sum of the others' normals.
#[derive(Debug, Default)]
pub(crate) struct Surroundings {
    /// The side of each line on which the vertex lies: 1, −1, or 0 for a line through it.
    pub(crate) signs: Vec<i8>,
    /// The lines through the vertex, without those whose normal is zero.
    pub(crate) through: Vec<u32>,
    /// linear + Σ sign · normal, rounded.
    pub(crate) gradient: [f64; 2],
    /// How far each coordinate of the gradient may be off.
    pub(crate) gradient_error: f64,
}

impl<'p> Instance<'p> {
    /// The whole problem.
    pub(crate) fn whole(problem: &'p LadProblem<'p>) -> Self {
        let linear = problem.approximate_linear();
        let source = ExactLinear::known(problem.linear.clone());
        Self::new(problem, Cow::Borrowed(&problem.columns), None, linear, source)
    }

    /// Some lines of an instance, with a linear term of their own.
    pub(crate) fn selection(&self, lines: &[u32], linear: [f64; 2], source: ExactLinear) -> Self {
        let mut columns = Columns::with_capacity(lines.len());
        for &line in lines {
            let [x, y] = self.normal(line);
            columns.push([x, y, self.columns.offset[line as usize]]);
        }
        let mut selection = Self::new(self.problem, Cow::Owned(columns), Some(self.positions(lines)), linear, source);
        (selection.own_offsets, selection.error) = (self.own_offsets, self.error);
        selection
    }

    /// Some lines of the instance in its own objective: the others have the given fixed signs, whose normals sum to
    /// `fixed_sum` within `fixed_error`.
    pub(crate) fn remainder(
        &self,
        lines: &[u32],
        columns: Columns,
        signs: Vec<i8>,
        fixed_sum: [f64; 2],
        fixed_error: f64,
    ) -> Self {
        let mut source = self.linear_source.clone();
        source.layers.push(Rc::new(FixedSigns { members: self.members.clone(), signs }));
        let linear = [self.linear[0] + fixed_sum[0], self.linear[1] + fixed_sum[1]];
        let members = Some(self.positions(lines));
        let mut remainder = Self::new(self.problem, Cow::Owned(columns), members, linear, source);
        (remainder.own_offsets, remainder.error) = (self.own_offsets, self.error);
        remainder.linear_error += self.linear_error + fixed_error;
        remainder
    }

    /// The lines through a vertex, moved apart to the given offsets, under a known linear term.
    pub(crate) fn moved_apart(&self, lines: &[u32], linear: [Dyadic; 2], offsets: Vec<f64>) -> Self {
        let rounded = [linear[0].to_f64(), linear[1].to_f64()];
        let mut moved = self.selection(lines, rounded, ExactLinear::known(linear));
        moved.columns.to_mut().offset = offsets;
        moved.own_offsets = true;
        moved.error = LineError { offset_relative: 0.0, offset_per_normal: 0.0 };
        moved
    }

    fn new(
        problem: &'p LadProblem<'p>,
        columns: Cow<'p, Columns>,
        members: Option<Rc<[u32]>>,
        linear: [f64; 2],
        linear_source: ExactLinear,
    ) -> Self {
        Self {
            problem,
            columns,
            members,
            own_offsets: false,
            error: problem.error,
            linear,
            linear_error: 8.0 * UNIT * (linear[0].abs() + linear[1].abs()) + UNDERFLOW,
            linear_source,
            exact_linear: OnceCell::new(),
            magnitude: OnceCell::new(),
        }
    }

    fn positions(&self, lines: &[u32]) -> Rc<[u32]> {
        lines.iter().map(|&line| self.position(line) as u32).collect()
    }

    /// The fixed signs of the lines that this remainder left out, one for each line of the instance it was taken from.
    pub(crate) fn fixed_signs(&self) -> &[i8] {
        self.linear_source.layers.last().map_or(&[], |layer| &layer.signs)
    }

    pub(crate) fn len(&self) -> usize {
        self.columns.len()
    }

    /// The position in the problem of a line of the instance.
    pub(crate) fn position(&self, line: u32) -> usize {
        self.members.as_ref().map_or(line, |members| members[line as usize]) as usize
    }

    pub(crate) fn normal(&self, line: u32) -> [f64; 2] {
        [self.columns.normal_x[line as usize], self.columns.normal_y[line as usize]]
    }

    pub(crate) fn exact_line(&self, line: u32) -> ExactLine {
        let mut exact = self.problem.exact.line(self.position(line));
        if self.own_offsets {
            exact.offset = Dyadic::from_f64(self.columns.offset[line as usize]);
        }
        exact
    }

    pub(crate) fn exact_linear(&self) -> &[Dyadic; 2] {
        self.exact_linear.get_or_init(|| self.linear_source.value(self.problem))
    }

    fn magnitude(&self) -> f64 {
        let sum = |column: &[f64]| column.iter().map(|v| v.abs()).sum::<f64>();
        *self.magnitude.get_or_init(|| sum(&self.columns.normal_x) + sum(&self.columns.normal_y))
    }

    /// linear + Σ sign · normal, exactly.
    pub(crate) fn exact_gradient(&self, signs: &[i8]) -> [Dyadic; 2] {
        let mut terms = signs.iter().enumerate().map(|(line, &sign)| (self.position(line as u32), sign));
        let [x, y] = self.problem.exact.signed_normal_sum(&mut terms);
        let [cx, cy] = self.exact_linear();
        [cx + &x, cy + &y]
    }

    /// Whether the normal of a line is exactly zero.
    pub(crate) fn has_zero_normal(&self, line: u32) -> bool {
        self.normal(line) == [0.0, 0.0] && self.exact_line(line).normal.iter().all(Dyadic::is_zero)
    }

    /// The sign of the cross product of the normals of two lines.
    pub(crate) fn cross_sign(&self, first: u32, second: u32) -> Ordering {
        let ([a, b], [c, d]) = (self.normal(first), self.normal(second));
        let (left, right) = (a * d, b * c);
        if (left - right).abs() > 8.0 * UNIT * (left.abs() + right.abs()) + UNDERFLOW {
            return (left - right).total_cmp(&0.0);
        }
        let ([a, b], [c, d]) = (self.exact_line(first).normal, self.exact_line(second).normal);
        (a * d).cmp(&(b * c))
    }

    /// Reads every line at a vertex, into `around`.
    ///
    /// A sign is taken from floating point when |value| exceeds a bound on its error: the vertex is within
    /// `vertex.error` of its double, the line within its [`LineError`], and each of the operations adds at most
    /// UNIT of its result, each result being at most |a x| + |a y| + |b| in magnitude.
    pub(crate) fn read_at(&self, vertex: &Vertex, around: &mut Surroundings, tally: &mut impl Tally) {
        let n = self.len();
        tally.add(Operation::LineEvaluation, n as u64);
        around.signs.clear();
        around.signs.resize(n, 0);
        around.through.clear();
        let bounds = self.bounds_at(vertex);
        let columns = &*self.columns;
        let mut gradient = self.linear;
        let mut undecided = Vec::new();
        for (block, signs) in around.signs.chunks_mut(BLOCK).enumerate() {
            let start = block * BLOCK;
            let range = start..start + signs.len();
            let (x, y) = (&columns.normal_x[range.clone()], &columns.normal_y[range.clone()]);
            let (sum, certain) = bounds.read_block(x, y, &columns.offset[range], signs);
            gradient[0] += sum[0];
            gradient[1] += sum[1];
            if !certain {
                undecided.extend((0..signs.len()).filter(|&i| signs[i] == 0).map(|i| (start + i) as u32));
            }
        }
        let additions = (BLOCK / LANES + LANES + n / BLOCK + undecided.len() + 8) as f64;
        for line in undecided {
            let side = if vertex.is_on(line) {
                0
            } else {
                tally.add(Operation::ExactFallback, 1);
                vertex.exact_side(&self.exact_line(line))
            };
            if side == 0 && !self.has_zero_normal(line) {
                around.through.push(line);
            }
            around.signs[line as usize] = side;
            let [x, y] = self.normal(line);
            gradient[0] += f64::from(side) * x;
            gradient[1] += f64::from(side) * y;
        }
        around.gradient = gradient;
        let total = self.magnitude() + self.linear[0].abs() + self.linear[1].abs();
        around.gradient_error = self.linear_error + UNIT * additions * total + UNDERFLOW;
    }

    fn bounds_at(&self, vertex: &Vertex) -> Bounds {
        let per_normal =
            |axis: usize| vertex.error[axis] + 8.0 * UNIT * vertex.point[axis].abs() + self.error.offset_per_normal;
        Bounds {
            point: vertex.point,
            per_normal: [per_normal(0), per_normal(1)],
            per_offset: self.error.offset_relative + 8.0 * UNIT,
            floor: UNDERFLOW * (1.0 + vertex.point[0].abs() + vertex.point[1].abs()),
        }
    }
}

/// A point and what bounds the error of a line's value there.
struct Bounds {
    point: [f64; 2],
    per_normal: [f64; 2],
    per_offset: f64,
    floor: f64,
}

impl Bounds {
    /// Writes the certain signs of a block of lines, 0 for the others; returns Σ sign · normal over the certain ones
    /// and whether all were.
    fn read_block(&self, x: &[f64], y: &[f64], offset: &[f64], signs: &mut [i8]) -> ([f64; 2], bool) {
        let ([px, py], [ex, ey], eb) = (self.point, self.per_normal, self.per_offset);
        let mut sums = [[0.0; LANES]; 2];
        let mut certain = true;
        let mut read = |lane: usize, x: f64, y: f64, b: f64, sign: &mut i8| {
            let value = x * px + y * py + b;
            let bound = x.abs() * ex + y.abs() * ey + b.abs() * eb + self.floor;
            let (above, below) = (value > bound, value < -bound);
            *sign = i8::from(above) - i8::from(below);
            let factor = f64::from(u8::from(above)) - f64::from(u8::from(below));
            certain &= above | below;
            sums[0][lane] += factor * x;
            sums[1][lane] += factor * y;
        };
        let lanes = x.chunks(LANES).zip(y.chunks(LANES)).zip(offset.chunks(LANES)).zip(signs.chunks_mut(LANES));
        for (((x, y), offset), signs) in lanes {
            for (lane, (((&x, &y), &b), sign)) in x.iter().zip(y).zip(offset).zip(signs).enumerate() {
                read(lane, x, y, b, sign);
            }
        }
        (sums.map(|lanes| lanes.iter().sum()), certain)
    }
}

/// Lines summed in parallel within a block; blocks join the running gradient one by one. The rounding error of the sum
/// is then at most (BLOCK / LANES + LANES + n / BLOCK) · UNIT of the sum of magnitudes rather than n · UNIT.
const LANES: usize = 8;
const BLOCK: usize = 512;
