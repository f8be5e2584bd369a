//! What a method answers: a minimiser named by its defining lines, with coefficients that prove it.

use super::descent::solution::{Near, Optimal, Solution};
use super::input::problem::LadProblem;
use super::subproblem::instance::{ExactLinear, Instance, Surroundings};
use super::subproblem::vertex::Vertex;
use crate::arrangement::ExactLine;
use crate::arrangement::LineIndex;
use crate::numeric::Rational;
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
    through: Vec<u32>,
    near: Option<Near>,
}

/// Coefficients δ in [−1, 1] that prove a minimiser x*: linear + Σ δ_i w_i a_i = 0, and δ_i (a_i · x* + b_i) =
/// |a_i · x* + b_i| for each line.
///
/// They give the lower bound Σ δ_i w_i b_i for the objective at every point, with equality at x*.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LadCertificate {
    /// δ for each line: 1 or −1; 0 for the basis and for lines without any coefficient.
    pub signs: Vec<i8>,
    /// The lines, at most two, whose δ solve the equation exactly.
    pub basis: Vec<LineIndex>,
}

impl LadCertificate {
    /// The coefficients of the basis lines as fractions, numerator and denominator, exactly. O(n) exact operations.
    pub(crate) fn basis_fractions(&self, problem: &LadProblem) -> Vec<[Dyadic; 2]> {
        let signed = self.signs.iter().enumerate().filter(|(_, sign)| **sign != 0).map(|(line, &sign)| (line, sign));
        let [x, y] = problem.exact.signed_normal_sum(&mut signed.into_iter());
        let rest = [-(&problem.linear[0] + &x), -(&problem.linear[1] + &y)];
        let cross = |a: &[Dyadic; 2], b: &[Dyadic; 2]| &a[0] * &b[1] - &a[1] * &b[0];
        let normal = |line: &LineIndex| problem.exact.line(line.position()).normal;
        match &self.basis[..] {
            [first, second] => {
                let (a, b) = (normal(first), normal(second));
                vec![[cross(&rest, &b), cross(&a, &b)], [cross(&a, &rest), cross(&a, &b)]]
            }
            [line] => {
                let a = normal(line);
                let axis = usize::from(a[0].is_zero());
                vec![[rest[axis].clone(), a[axis].clone()]]
            }
            _ => Vec::new(),
        }
    }
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
        let Optimal { face_dimension, through, near, .. } = optimal;
        Self { minimizer, face_dimension, certificate, through, near }
    }

    /// The minimiser in homogeneous coordinates [X, Y, W], W > 0: the point (X / W, Y / W), exactly. On a line it is the point
    /// nearest to the origin, in the plane the origin.
    pub fn homogeneous_point(&self, problem: &LadProblem) -> [Dyadic; 3] {
        self.minimizer.homogeneous_point(|line| problem.exact_line(line))
    }

    /// The side of each line on which a point of the scaled frame lies, given in homogeneous coordinates with W > 0. At the minimiser no line
    /// is read, near it only those that may pass between the two.
    pub(crate) fn signs_at(&self, problem: &LadProblem, point: &[Dyadic; 3]) -> Vec<i8> {
        if self.is_at(problem, point) {
            let mut signs = self.certificate.signs.clone();
            self.through.iter().for_each(|&line| signs[line as usize] = 0);
            return signs;
        }
        let vertex = Vertex::at(point.clone());
        let Some(Near { crossing, .. }) = self.near.as_ref().filter(|near| near.cell.contains(vertex.point)) else {
            return problem.signs_at(point, &mut ());
        };
        let no_linear_term = ExactLinear::known([Dyadic::zero(), Dyadic::zero()]);
        let mut around = Surroundings::default();
        let crossing_lines = Instance::whole(problem).selection(crossing, [0.0, 0.0], no_linear_term);
        crossing_lines.read_at(&vertex, &mut around, &mut ());
        let mut signs = self.certificate.signs.clone();
        for (&line, sign) in crossing.iter().zip(around.signs) {
            signs[line as usize] = sign;
        }
        signs
    }

    /// Whether a point of the scaled frame is the minimiser.
    pub(crate) fn is_at(&self, problem: &LadProblem, [x, y, w]: &[Dyadic; 3]) -> bool {
        let [own_x, own_y, own_w] = self.minimizer.homogeneous_point(|line| problem.exact.line(line.position()));
        &own_x * w == x * &own_w && &own_y * w == y * &own_w
    }

    /// The minimiser, exactly.
    pub fn exact_point(&self, problem: &LadProblem) -> [Rational; 2] {
        let [x, y, w] = self.homogeneous_point(problem).map(|v| v.to_rational());
        [x / &w, y / w]
    }

    /// The minimiser, each coordinate within a relative 2^-50.
    pub fn point(&self, problem: &LadProblem) -> [f64; 2] {
        let [x, y, w] = self.homogeneous_point(problem);
        [x.ratio(&w), y.ratio(&w)]
    }

    /// The minimum, exactly. O(n) exact operations.
    pub fn exact_value(&self, problem: &LadProblem) -> Rational {
        let point = self.homogeneous_point(problem);
        let [cx, cy] = problem.exact_linear();
        let linear = &cx * &point[0] + &cy * &point[1];
        let lines = (0..problem.len() as u32).map(LineIndex);
        let total = lines.fold(linear, |sum, line| sum + problem.exact_line(line).evaluate(&point).abs());
        total.to_rational() / point[2].to_rational()
    }
}

impl Minimizer {
    /// The minimiser of the lines that `line` knows, in homogeneous coordinates as in [`LadOptimum::homogeneous_point`].
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
