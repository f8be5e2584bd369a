//! The answer of a method: a minimiser named by its defining lines, with coefficients that prove it.
//!
//! A minimiser is a pair of lines and not a point: its coordinates are rational, mostly not doubles, and the lines say
//! it exactly in eight bytes. Whoever wants coordinates asks for them, exactly or rounded.

use super::certificate::LadCertificate;
use super::descent::{Near, Optimal, Solution};
use super::input::LadProblem;
use crate::arrangement::{ExactLine, LineIndex};
use crate::numeric::Rational;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;

/// The outcome of a minimisation.
#[derive(Debug, Clone)]
pub enum LadOutcome {
    /// The minimum is attained.
    Optimal(LadOptimum),
    /// The objective falls without bound along this direction from every point.
    Unbounded {
        /// The direction, exactly.
        direction: [Dyadic; 2],
    },
}

/// A point at which the minimum is attained.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Minimizer {
    /// The point where two lines cross.
    Vertex(LineIndex, LineIndex),
    /// Every point of a line: all lines are parallel.
    Line(LineIndex),
    /// Every point of the plane: every normal is zero.
    Plane,
}

/// A minimiser with its proof.
#[derive(Debug, Clone)]
pub struct LadOptimum {
    /// The minimiser.
    pub minimizer: Minimizer,
    /// The dimension of the set of all minimisers: 0 when it is unique.
    pub face_dimension: u8,
    /// The proof.
    pub certificate: LadCertificate,
    /// The lines through the minimiser whose normal is not zero.
    pub(super) through: Vec<u32>,
    /// The minimiser by pairs of doubles, where it was found by them.
    pub(crate) place: Option<[BoundedDoubleDouble; 2]>,
    /// A cell in which most lines have the sign that they have at the minimiser, where pruning found one.
    pub(super) near: Option<Near>,
}

impl LadOutcome {
    pub(crate) fn new(solution: Solution) -> Self {
        match solution {
            Solution::Optimal(optimal) => Self::Optimal(LadOptimum::new(*optimal)),
            Solution::Unbounded { direction, .. } => Self::Unbounded { direction },
        }
    }

    /// The optimum, if there is one.
    pub fn optimum(&self) -> Option<&LadOptimum> {
        match self {
            Self::Optimal(optimum) => Some(optimum),
            Self::Unbounded { .. } => None,
        }
    }

    /// The optimum, if there is one, without the outcome.
    pub fn into_optimum(self) -> Option<LadOptimum> {
        match self {
            Self::Optimal(optimum) => Some(optimum),
            Self::Unbounded { .. } => None,
        }
    }
}

impl LadOptimum {
    fn new(optimal: Optimal) -> Self {
        let minimizer = match optimal.defining[..] {
            [first, second] => Minimizer::Vertex(LineIndex(first), LineIndex(second)),
            [line] => Minimizer::Line(LineIndex(line)),
            _ => Minimizer::Plane,
        };
        let basis = optimal.basis.into_iter().map(LineIndex).collect();
        let certificate = LadCertificate { signs: optimal.signs, basis };
        let Optimal { face_dimension, through, near, vertex, .. } = optimal;
        let place = vertex.and_then(|vertex| vertex.place);
        Self { minimizer, face_dimension, certificate, through, place, near }
    }

    /// The minimiser in homogeneous coordinates [X, Y, W], W > 0: the point (X / W, Y / W), exactly. On a line it is
    /// the point nearest to the origin, in the plane the origin.
    ///
    /// `None` if the optimum is of another problem: the minimiser names a line that this one does not have, or two that
    /// are parallel here. So it is for [`exact_point`](Self::exact_point), [`point`](Self::point) and
    /// [`exact_value`](Self::exact_value).
    pub fn homogeneous_point(&self, problem: &LadProblem) -> Option<[Dyadic; 3]> {
        let is_known = |line: LineIndex| line.position() < problem.len();
        let are_known = match self.minimizer {
            Minimizer::Vertex(first, second) => is_known(first) && is_known(second),
            Minimizer::Line(line) => is_known(line),
            Minimizer::Plane => true,
        };
        let point = are_known.then(|| self.point_in(problem));
        point.filter(|[.., w]| w.sign().is_gt())
    }

    /// The minimiser in homogeneous coordinates, for the problem that was solved.
    pub(crate) fn point_in(&self, problem: &LadProblem) -> [Dyadic; 3] {
        self.minimizer.homogeneous_point(|line| problem.exact_line(line))
    }

    /// The exact minimiser; `None` if the optimum is of another problem.
    pub fn exact_point(&self, problem: &LadProblem) -> Option<[Rational; 2]> {
        let [x, y, w] = self.homogeneous_point(problem)?.map(|v| v.to_rational());
        Some([x / &w, y / w])
    }

    /// The minimiser, each coordinate within a relative 2^-50; `None` if the optimum is of another problem.
    pub fn point(&self, problem: &LadProblem) -> Option<[f64; 2]> {
        let [x, y, w] = self.homogeneous_point(problem)?;
        Some([x.ratio(&w), y.ratio(&w)])
    }

    /// The exact minimum; `None` if the optimum is of another problem. O(n) exact operations.
    pub fn exact_value(&self, problem: &LadProblem) -> Option<Rational> {
        let point = self.homogeneous_point(problem)?;
        let [cx, cy] = problem.exact_linear();
        let linear = &cx * &point[0] + &cy * &point[1];
        let lines = (0..problem.len() as u32).map(LineIndex);
        let total = lines.fold(linear, |sum, line| sum + problem.exact_line(line).evaluate(&point).abs());
        Some(total.to_rational() / point[2].to_rational())
    }
}

impl Minimizer {
    /// The minimiser of the lines that `line` knows, in homogeneous coordinates as in
    /// [`LadOptimum::homogeneous_point`].
    pub(crate) fn homogeneous_point(&self, line: impl Fn(LineIndex) -> ExactLine) -> [Dyadic; 3] {
        match *self {
            Self::Vertex(first, second) => line(first).meet(&line(second)),
            Self::Line(index) => {
                let line = line(index);
                line.meet(&ExactLine { normal: line.direction(), offset: Dyadic::zero() })
            }
            Self::Plane => [Dyadic::zero(), Dyadic::zero(), Dyadic::from_f64(1.0)],
        }
    }
}
