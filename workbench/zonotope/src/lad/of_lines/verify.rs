//! Checks the proof of an optimum in exact arithmetic, without any code of the methods.
//!
//! A minimiser is proved by coefficients δ in [−1, 1] with linear + Σ δ a = 0 and δ (a · x* + b) = |a · x* + b|
//! (weights multiplied in): for every x then linear · x + Σ |a · x + b| ≥ linear · x + Σ δ (a · x + b) = Σ δ b, and at
//! x* both sides are equal. O(n) exact operations.

use thiserror::Error;

use super::certificate::LadCertificate;
use super::input::LadProblem;
use super::optimum::{LadOptimum, LadOutcome, Minimizer};
use crate::arrangement::LineIndex;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// Why a proof fails.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LadVerifyError {
    /// The certificate does not have one sign a line.
    #[error("{signs} signs for {lines} lines")]
    Length {
        /// How many signs there are.
        signs: usize,
        /// How many lines there are.
        lines: usize,
    },
    /// The minimiser or the basis names a line that the problem does not have.
    #[error("there is no line {}", line.0)]
    UnknownLine {
        /// The index.
        line: LineIndex,
    },
    /// The minimiser's lines do not meet in a point.
    #[error("the defining lines do not define a point")]
    NotAPoint,
    /// A sign is not the side of the line on which the minimiser lies.
    #[error("line {}: the sign {sign} is not that of its value at the minimiser", line.0)]
    WrongSign {
        /// The line.
        line: LineIndex,
        /// Its sign in the certificate.
        sign: i8,
    },
    /// The coefficients do not sum to zero with any choice of the basis coefficients in [−1, 1].
    #[error("the basis coefficients that solve the equation are not in [-1, 1]")]
    Basis,
    /// The direction of an unbounded problem does not descend for ever.
    #[error("the objective does not fall for ever in the given direction")]
    NotDescending,
}

/// Checks the certificate of an outcome.
///
/// # Errors
/// [`LadVerifyError`] says what does not hold.
pub fn verify(problem: &LadProblem, outcome: &LadOutcome) -> Result<(), LadVerifyError> {
    match outcome {
        LadOutcome::Optimal(optimum) => verify_optimum(problem, optimum),
        LadOutcome::Unbounded { direction } => verify_direction(problem, direction),
    }
}

fn verify_direction(problem: &LadProblem, [x, y]: &[Dyadic; 2]) -> Result<(), LadVerifyError> {
    let along = |[a, b]: &[Dyadic; 2]| a * x + b * y;
    let start = along(&problem.exact_linear());
    let slope = (0..problem.len() as u32)
        .fold(start, |sum, line| sum + along(&problem.exact_line(LineIndex(line)).normal).abs());
    if slope.sign().is_lt() { Ok(()) } else { Err(LadVerifyError::NotDescending) }
}

fn verify_optimum(problem: &LadProblem, optimum: &LadOptimum) -> Result<(), LadVerifyError> {
    let LadCertificate { signs, basis } = &optimum.certificate;
    if signs.len() != problem.len() {
        return Err(LadVerifyError::Length { signs: signs.len(), lines: problem.len() });
    }
    let named = match optimum.minimizer {
        Minimizer::Vertex(first, second) => vec![first, second],
        Minimizer::Line(line) => vec![line],
        Minimizer::Plane => Vec::new(),
    };
    if let Some(&line) = named.iter().chain(basis).find(|line| line.position() >= problem.len()) {
        return Err(LadVerifyError::UnknownLine { line });
    }
    let point = optimum.homogeneous_point(problem).ok_or(LadVerifyError::NotAPoint)?;
    let [mut gx, mut gy] = problem.exact_linear();
    for (line, &sign) in (0..).map(LineIndex).zip(signs) {
        let exact = problem.exact_line(line);
        let side = exact.evaluate(&point).sign() as i8;
        let constant = exact.normal.iter().all(Dyadic::is_zero);
        let agrees = if constant {
            sign == side
        } else if basis.contains(&line) {
            sign == 0 && side == 0
        } else {
            [1, -1].contains(&sign) && (side == 0 || side == sign)
        };
        if !agrees {
            return Err(LadVerifyError::WrongSign { line, sign });
        }
        if sign != 0 {
            let signed = exact.normal.map(|v| if sign < 0 { -v } else { v });
            let [x, y] = signed;
            (gx, gy) = (gx + x, gy + y);
        }
    }
    if basis_solves(problem, basis, [gx, gy]) { Ok(()) } else { Err(LadVerifyError::Basis) }
}

/// Whether rest + Σ δ normal = 0 over the basis for some δ in [−1, 1].
fn basis_solves(problem: &LadProblem, basis: &[LineIndex], rest: [Dyadic; 2]) -> bool {
    let normal = |line: LineIndex| problem.exact_line(line).normal.map(|v| v.to_rational());
    let [rx, ry] = rest.map(|v| v.to_rational());
    let cross = |[ax, ay]: &[Rational; 2], [bx, by]: &[Rational; 2]| ax * by - ay * bx;
    let inside = |coefficient: &Rational| *coefficient >= Rational::from(-1) && *coefficient <= Rational::ONE;
    let rest = [-rx, -ry];
    match *basis {
        [] => rest.iter().all(|v| *v == Rational::ZERO),
        [line] => {
            let a = normal(line);
            let axis = usize::from(a[0] == Rational::ZERO);
            a[axis] != Rational::ZERO && cross(&a, &rest) == Rational::ZERO && inside(&(&rest[axis] / &a[axis]))
        }
        [first, second] => {
            let (a, b) = (normal(first), normal(second));
            let determinant = cross(&a, &b);
            determinant != Rational::ZERO
                && inside(&(cross(&rest, &b) / &determinant))
                && inside(&(cross(&a, &rest) / &determinant))
        }
        _ => false,
    }
}
