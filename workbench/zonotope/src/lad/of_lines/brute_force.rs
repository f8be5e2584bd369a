//! Weighted least absolute deviations in the plane, by evaluating the objective at every vertex: the truth the methods
//! are held to.
//!
//! # Statement
//! Input: lines with weights and a linear term ([`LadProblem`]). Output: the exact minimum, every vertex at which it is
//! taken and the dimension of the set of minimisers, or that the objective is unbounded; by [`solve`] one of these
//! vertices with a certificate, or a direction along which the objective falls for ever.
//!
//! # Source
//! The objective is linear on each cell of the arrangement of the lines, so where two lines cross and the minimum is
//! attained it is attained at a vertex; it is unbounded iff it falls for ever along one of the lines, or, when all
//! lines are parallel, along or across them.
//!
//! # Method
//! 1. Take as candidate directions those of all lines and, when no two lines cross, their normals, and the linear term.
//! 2. If the objective falls for ever along one of them, it is unbounded.
//! 3. Else evaluate it at every crossing of two lines; when there is none, where each line meets its normal through the
//!    origin; when there are no lines, at the origin.
//! 4. The set of minimisers is spanned by the minimal vertices and the directions along which the objective is constant
//!    at one of them.
//! 5. For the certificate, go through the lines that meet in the first minimal vertex and give each a coefficient 1 or
//!    −1 that leaves the rest of the subgradient a sum of the remaining normals with coefficients in [−1, 1]. Where
//!    neither does, the line stays: in the end at most two independent ones are left, since more would leave a
//!    coefficient free to reach 1 or −1.
//!
//! # Complexity
//! O(n³) rational operations, those of the certificate included; space O(n²).
//!
//! # Shapes
//! `problem`: n lines in any order, duplicates allowed; n up to about 40.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
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

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::certificate::LadCertificate;
use super::input::LadProblem;
use super::optimum::{LadOptimum, LadOutcome, Minimizer};
use crate::arrangement::{ExactLine, LineIndex};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{determinant, dot};

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
    Objective::of(problem).minimum().ok().map(|(truth, _)| truth)
}

/// The first minimal vertex with its certificate, or a direction along which the objective is unbounded.
pub fn solve(problem: &LadProblem) -> LadOutcome {
    let objective = Objective::of(problem);
    match objective.minimum() {
        Err([x, y]) => {
            let integer = |own: &Rational, other: &Rational| {
                Dyadic::new(own.numerator() * IBig::from(other.denominator().clone()), 0)
            };
            LadOutcome::Unbounded { direction: [integer(&x, &y), integer(&y, &x)] }
        }
        Ok((truth, minimizer)) => {
            let through = objective.through(&truth.minimizers[0]);
            let certificate = objective.certificate(&truth.minimizers[0], &through);
            LadOutcome::Optimal(LadOptimum {
                minimizer,
                face_dimension: truth.face_dimension,
                certificate,
                through: through.into_iter().map(|line| line as u32).collect(),
                place: None,
                near: None,
            })
        }
    }
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
        let determinant = determinant(&[&self.normal[..], &other.normal[..]]);
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
    fn of(problem: &LadProblem) -> Self {
        let lines = (0..problem.len() as u32).map(|i| Line::new(problem.exact_line(LineIndex(i)))).collect();
        Self { linear: problem.exact_linear().map(|v| v.to_rational()), lines }
    }

    /// The minimum and the lines that define its first vertex, or a direction along which the objective falls for ever.
    fn minimum(&self) -> Result<(Truth, Minimizer), Vector> {
        let directions = self.directions();
        if let Some(falling) = directions.iter().find(|u| self.slope_at_infinity(u) < Rational::ZERO) {
            return Err(falling.clone());
        }
        let candidates = self.candidates();
        let values: Vec<Rational> = candidates.iter().map(|(x, _)| self.value(x)).collect();
        let value = values.iter().min().expect("there is always a candidate").clone();
        let first = values.iter().position(|v| *v == value).expect("the least value is among them");
        let minimizer = candidates[first].1;
        let mut minimizers: Vec<Vector> = Vec::new();
        for ((x, _), _) in candidates.into_iter().zip(&values).filter(|(_, v)| **v == value) {
            if !minimizers.contains(&x) {
                minimizers.push(x);
            }
        }
        let start = &minimizers[0];
        let mut spanning: Vec<Vector> = minimizers.iter().map(|x| [&x[0] - &start[0], &x[1] - &start[1]]).collect();
        spanning.extend(directions.into_iter().filter(|u| self.slope(start, u) == Rational::ZERO));
        let face_dimension = rank(&spanning);
        Ok((Truth { value, minimizers, face_dimension }, minimizer))
    }

    /// The lines through a point, without those whose normal is zero.
    fn through(&self, x: &Vector) -> Vec<usize> {
        let passes = |line: &Line| line.value(x) == Rational::ZERO && !is_zero(&line.normal);
        (0..self.lines.len()).filter(|&line| passes(&self.lines[line])).collect()
    }

    /// Coefficients that prove a minimiser, given the lines through it.
    fn certificate(&self, x: &Vector, through: &[usize]) -> LadCertificate {
        let sign = |line: &Line| line.value(x).cmp(&Rational::ZERO) as i8;
        let mut signs: Vec<i8> = self.lines.iter().map(sign).collect();
        let mut rest = self.linear.clone().map(|v| -v);
        for (line, &sign) in self.lines.iter().zip(&signs) {
            rest = minus(&rest, &line.normal, sign);
        }
        let mut left = through.to_vec();
        for &line in through {
            let others: Vec<&Vector> = left.iter().filter(|&&l| l != line).map(|&l| &self.lines[l].normal).collect();
            let fits = |sign: &i8| is_in_zonogon(&minus(&rest, &self.lines[line].normal, *sign), &others);
            if let Some(sign) = [1, -1].into_iter().find(fits) {
                rest = minus(&rest, &self.lines[line].normal, sign);
                signs[line] = sign;
                left.retain(|&l| l != line);
            }
        }
        LadCertificate { signs, basis: left.into_iter().map(|line| LineIndex(line as u32)).collect() }
    }

    fn value(&self, x: &Vector) -> Rational {
        self.lines.iter().fold(dot(&self.linear, x), |sum, line| sum + line.value(x).abs())
    }

    /// Every direction along which the objective must be tried: both ways along each line and across it, and along the
    /// linear term.
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
        self.lines.iter().fold(dot(&self.linear, u), |sum, line| sum + dot(&line.normal, u).abs())
    }

    fn slope(&self, x: &Vector, u: &Vector) -> Rational {
        self.lines.iter().fold(dot(&self.linear, u), |sum, line| {
            let (value, rate) = (line.value(x), dot(&line.normal, u));
            match value.cmp(&Rational::ZERO) {
                std::cmp::Ordering::Greater => sum + rate,
                std::cmp::Ordering::Less => sum - rate,
                std::cmp::Ordering::Equal => sum + rate.abs(),
            }
        })
    }

    /// The points of which one is minimal, each with the lines that define it.
    fn candidates(&self) -> Vec<(Vector, Minimizer)> {
        let indexed = || (0..).map(LineIndex).zip(&self.lines);
        let pairs = indexed().flat_map(|(i, a)| indexed().take(i.position()).map(move |(j, b)| ((i, a), (j, b))));
        let meet = |((i, a), (j, b)): ((_, &Line), (_, &Line))| Some((a.meet(b)?, Minimizer::Vertex(i, j)));
        let crossings: Vec<_> = pairs.filter_map(meet).collect();
        if !crossings.is_empty() {
            return crossings;
        }
        let feet: Vec<_> = indexed().filter_map(|(i, line)| Some((line.foot()?, Minimizer::Line(i)))).collect();
        if feet.is_empty() { vec![([Rational::ZERO, Rational::ZERO], Minimizer::Plane)] } else { feet }
    }
}

/// v − sign · normal.
fn minus(v: &Vector, normal: &Vector, sign: i8) -> Vector {
    let sign = Rational::from(sign);
    [&v[0] - &sign * &normal[0], &v[1] - &sign * &normal[1]]
}

/// Whether a vector is a sum of the generators with coefficients in [−1, 1].
///
/// The zonogon of the generators is where v · u ≤ Σ |generator · u| for the normals u of its edges; where it is a
/// segment or a point, also for the direction of the segment, or for both axes.
fn is_in_zonogon(v: &Vector, generators: &[&Vector]) -> bool {
    let turned = |g: &Vector| [-g[1].clone(), g[0].clone()];
    let axes = [[1, 0], [0, 1]].map(|u| u.map(Rational::from));
    let normals = generators.iter().flat_map(|g| [turned(g), (*g).clone()]).chain(axes);
    let is_within = |u: Vector| {
        let width = generators.iter().fold(Rational::ZERO, |sum, g| sum + dot(g, &u).abs());
        dot(v, &u).abs() <= width
    };
    normals.into_iter().all(is_within)
}

fn is_zero(v: &Vector) -> bool {
    v.iter().all(|v| *v == Rational::ZERO)
}

fn rank(vectors: &[Vector]) -> u8 {
    let zero = [Rational::ZERO, Rational::ZERO];
    match vectors.iter().find(|v| **v != zero) {
        None => 0,
        Some(first) if vectors.iter().any(|v| determinant(&[&first[..], &v[..]]) != Rational::ZERO) => 2,
        Some(_) => 1,
    }
}
