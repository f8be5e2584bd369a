//! The subdifferential of the objective at a vertex, from one pass over the lines.

use std::cell::OnceCell;

use super::part::Subproblem;
use super::sign_pass::{Reading, read_sides};
use super::vertex::Vertex;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::{Operation, Tally};

/// The subdifferential at a vertex: gradient + Σ δ normal with δ in [−1, 1] over the lines through it.
#[derive(Debug, Default)]
pub(crate) struct Subdifferential {
    /// The side of each line on which the vertex lies: 1, −1, or 0 for a line through it.
    pub(crate) signs: Vec<i8>,
    /// The lines through the vertex, without those whose normal is zero.
    pub(crate) through: Vec<u32>,
    /// The rounded sum linear + Σ sign · normal.
    pub(crate) gradient: [f64; 2],
    /// A bound on the error of each coordinate of the gradient.
    pub(crate) gradient_error: f64,
    /// The same sum exactly, made when a decision needs it.
    exact_gradient: OnceCell<[Dyadic; 2]>,
}

impl Subdifferential {
    /// The exact sum linear + Σ sign · normal; the subproblem must be the one that was read.
    pub(crate) fn exact_gradient(&self, subproblem: &Subproblem) -> &[Dyadic; 2] {
        self.exact_gradient.get_or_init(|| subproblem.exact_gradient(&self.signs))
    }
}

/// Lines whose side floating point leaves open.
#[derive(Debug, Default)]
struct Undecided {
    count: usize,
    /// The sum Σ side · normal.
    sum: [f64; 2],
    /// The sum Σ |normal|.
    size: f64,
}

impl Undecided {
    fn add(&mut self, side: i8, [x, y]: [f64; 2]) {
        self.count += 1;
        self.sum[0] += f64::from(side) * x;
        self.sum[1] += f64::from(side) * y;
        self.size += x.abs() + y.abs();
    }
}

impl Subproblem<'_> {
    /// Reads every line at a vertex, and leaves its subdifferential in `around`.
    ///
    /// A sign is taken from floating point when |value| exceeds a bound on its error: the vertex is within
    /// `vertex.error` of its double, the line within its [`LineError`], and each of the operations adds at most
    /// UNIT of its result, each result being at most |a x| + |a y| + |b| in magnitude.
    pub(crate) fn read_at(&self, vertex: &Vertex, around: &mut Subdifferential, tally: &mut impl Tally) {
        self.count_pass(tally);
        let Subdifferential { signs, through, exact_gradient, .. } = around;
        through.clear();
        exact_gradient.take();
        let ([px, py], [vx, vy]) = (vertex.point, vertex.error);
        let floor = UNDERFLOW * (1.0 + px.abs() + py.abs());
        let exact_side = self.exact_sides(vertex);
        let mut undecided = Undecided::default();
        let sides = read_sides(
            &self.lines,
            signs,
            |error| {
                let per_normal = |value: f64, off: f64| off + 8.0 * UNIT * value.abs() + error.offset_per_normal;
                Reading {
                    point: [px, py],
                    across: [0.0; 2],
                    per_x: per_normal(px, vx),
                    per_y: per_normal(py, vy),
                    per_offset: error.offset_relative + 8.0 * UNIT,
                    floor,
                }
            },
            |line, [x, y, _], _| {
                let line = line as u32;
                let side = if vertex.is_on(line) {
                    0
                } else {
                    tally.add(Operation::ExactFallback, 1);
                    exact_side(line)
                };
                if side == 0 && !([x, y] == [0.0, 0.0] && self.has_zero_normal(line)) {
                    through.push(line);
                }
                undecided.add(side, [x, y]);
                side
            },
        );
        around.gradient = [0, 1].map(|axis| self.linear[axis] + sides.sum[axis] + undecided.sum[axis]);
        let additions = (undecided.count + 8) as f64;
        // |sides.sum| is at most the sum of the sizes that its error is a multiple of.
        let size = undecided.size + self.linear[0].abs() + self.linear[1].abs() + sides.sum_error / UNIT;
        around.gradient_error = self.linear_error + sides.sum_error + UNIT * additions * size + UNDERFLOW;
    }
}
