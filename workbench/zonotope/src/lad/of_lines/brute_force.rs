//! Weighted least absolute deviations in the plane, by evaluating the objective at every vertex: the truth the methods are held to.
//!
//! # Statement
//! Input: lines with weights and a linear term ([`LadProblem`]). Output: the exact minimum, every vertex at which it is
//! taken and the dimension of the set of minimisers, or that the objective is unbounded.
//!
//! # Source
//! The objective is linear on each cell of the arrangement of the lines, so where two lines cross and the minimum is attained it
//! is attained at a vertex; it is unbounded iff it falls for ever along one of the lines, or, when all lines are
//! parallel, along or across them.
//!
//! # Method
//! 1. Take as candidate directions those of all lines and, when no two lines cross, their normals, and the linear term.
//! 2. If the objective falls for ever along one of them, it is unbounded.
//! 3. Else evaluate it at every crossing of two lines; when there is none, where each line meets its normal through the
//!    origin; when there are no lines, at the origin.
//! 4. The set of minimisers is spanned by the minimal vertices and the directions along which the objective is constant at one of them.
//!
//! # Complexity
//! O(n³) rational operations; space O(n²).
//!
//! # Shapes
//! `problem`: n lines in any order, duplicates allowed; n up to about 40.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Errors
//! None: the problem was validated when it was made.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! Hand-worked examples; its simplicity.
//!
//! # Example
//! ```
//! use zonotope::lad::{LadProblem, WeightedLine, brute_force};
//! let line = |a, b| WeightedLine::unweighted(a, b);
//! let problem = LadProblem::new(&[line([1.0, 0.0], -1.0), line([0.0, 1.0], -2.0)], [0.0, 0.0]).unwrap();
//! let truth = brute_force::minimize(&problem).unwrap();
//! assert_eq!((truth.value, truth.face_dimension), (0.into(), 0));
//! ```

use super::input::LadProblem;
use crate::arrangement::ExactLine;
use crate::arrangement::LineIndex;
use crate::numeric::Rational;

type Vector = [Rational; 2];

/// The exact minimum and where it is taken.
#[derive(Debug, Clone)]
pub struct Truth {
    /// The minimum.
    pub value: Rational,
    /// The minimal vertices, without repetition; when no two lines cross, the minimal feet.
    pub minimizers: Vec<[Rational; 2]>,
    /// The dimension of the set of minimisers.
    pub face_dimension: u8,
}

/// The minimum of a problem; `None` when the objective is unbounded.
pub fn minimize(problem: &LadProblem) -> Option<Truth> {
    let lines: Vec<Line> = (0..problem.len() as u32).map(|i| Line::new(problem.exact_line(LineIndex(i)))).collect();
    let linear = problem.exact_linear().map(|v| v.to_rational());
    let objective = Objective { linear, lines };
    let directions = objective.directions();
    if directions.iter().any(|u| objective.slope_at_infinity(u) < Rational::ZERO) {
        return None;
    }
    let candidates = objective.candidates();
    let values: Vec<Rational> = candidates.iter().map(|x| objective.value(x)).collect();
    let value = values.iter().min().expect("there is always a candidate").clone();
    let mut minimizers: Vec<Vector> = Vec::new();
    for (x, _) in candidates.into_iter().zip(&values).filter(|(_, v)| **v == value) {
        if !minimizers.contains(&x) {
            minimizers.push(x);
        }
    }
    let start = &minimizers[0];
    let mut spanning: Vec<Vector> = minimizers.iter().map(|x| [&x[0] - &start[0], &x[1] - &start[1]]).collect();
    spanning.extend(directions.into_iter().filter(|u| objective.slope(start, u) == Rational::ZERO));
    let face_dimension = rank(&spanning);
    Some(Truth { value, minimizers, face_dimension })
}

struct Line {
    normal: Vector,
    offset: Rational,
}

struct Objective {
    linear: Vector,
    lines: Vec<Line>,
}

impl Line {
    fn new(exact: ExactLine) -> Self {
        Self { normal: exact.normal.map(|v| v.to_rational()), offset: exact.offset.to_rational() }
    }

    fn value(&self, x: &Vector) -> Rational {
        dot(&self.normal, x) + &self.offset
    }

    fn foot(&self) -> Option<Vector> {
        let length = dot(&self.normal, &self.normal);
        let [x, y] = &self.normal;
        (length != Rational::ZERO).then(|| [-(&self.offset * x) / &length, -(&self.offset * y) / &length])
    }

    fn meet(&self, other: &Self) -> Option<Vector> {
        let determinant = cross(&self.normal, &other.normal);
        let ([a, b], [c, d]) = (&self.normal, &other.normal);
        (determinant != Rational::ZERO).then(|| {
            [
                (b * &other.offset - d * &self.offset) / &determinant,
                (c * &self.offset - a * &other.offset) / &determinant,
            ]
        })
    }
}

impl Objective {
    fn value(&self, x: &Vector) -> Rational {
        self.lines.iter().fold(dot(&self.linear, x), |sum, line| sum + absolute(line.value(x)))
    }

    /// Every direction along which the objective must be tried: both ways along each line and across it, and along the linear term.
    fn directions(&self) -> Vec<Vector> {
        let normals = self.lines.iter().map(|line| &line.normal);
        let both = |[x, y]: Vector| [[x.clone(), y.clone()], [-x, -y]];
        let along = normals.clone().flat_map(|[x, y]| both([-y.clone(), x.clone()]));
        let across = normals.flat_map(|n| both(n.clone()));
        let linear =
            both(self.linear.clone()).into_iter().chain(both([-self.linear[1].clone(), self.linear[0].clone()]));
        let units = [[1, 0], [-1, 0], [0, 1], [0, -1]].map(|u| u.map(Rational::from));
        along.chain(across).chain(linear).chain(units).filter(|u| *u != [Rational::ZERO, Rational::ZERO]).collect()
    }

    fn slope_at_infinity(&self, u: &Vector) -> Rational {
        self.lines.iter().fold(dot(&self.linear, u), |sum, line| sum + absolute(dot(&line.normal, u)))
    }

    fn slope(&self, x: &Vector, u: &Vector) -> Rational {
        self.lines.iter().fold(dot(&self.linear, u), |sum, line| {
            let (value, rate) = (line.value(x), dot(&line.normal, u));
            match value.cmp(&Rational::ZERO) {
                std::cmp::Ordering::Greater => sum + rate,
                std::cmp::Ordering::Less => sum - rate,
                std::cmp::Ordering::Equal => sum + absolute(rate),
            }
        })
    }

    fn candidates(&self) -> Vec<Vector> {
        let pairs = self.lines.iter().enumerate().flat_map(|(i, a)| self.lines[..i].iter().map(move |b| (a, b)));
        let crossings: Vec<Vector> = pairs.filter_map(|(a, b)| a.meet(b)).collect();
        if !crossings.is_empty() {
            return crossings;
        }
        let feet: Vec<Vector> = self.lines.iter().filter_map(Line::foot).collect();
        if feet.is_empty() { vec![[Rational::ZERO, Rational::ZERO]] } else { feet }
    }
}

fn dot([a, b]: &Vector, [c, d]: &Vector) -> Rational {
    a * c + b * d
}

fn cross([a, b]: &Vector, [c, d]: &Vector) -> Rational {
    a * d - b * c
}

fn absolute(value: Rational) -> Rational {
    if value < Rational::ZERO { -value } else { value }
}

fn rank(vectors: &[Vector]) -> u8 {
    let zero = [Rational::ZERO, Rational::ZERO];
    match vectors.iter().find(|v| **v != zero) {
        None => 0,
        Some(first) if vectors.iter().any(|v| cross(first, v) != Rational::ZERO) => 2,
        Some(_) => 1,
    }
}
