//! An independent check of an outcome in space, in exact rationals.

use thiserror::Error;

use super::outcome::{SpaceOptimum, SpaceOutcome};
use super::problem::SpaceLadProblem;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{determinant, dot};

/// Why an outcome is not proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SpaceVerifyError {
    /// The certificate has not one sign for each plane, or its basis is not at most three planes in increasing order.
    #[error("the certificate does not fit the problem")]
    Shape,
    /// A sign disagrees with the side on which the point lies.
    #[error("the sign of plane {plane} is wrong")]
    Sign {
        /// The plane, from 0.
        plane: usize,
    },
    /// No coefficients of the basis in [−1, 1] make the subgradient vanish.
    #[error("the subgradient does not vanish")]
    Subgradient,
    /// The stated minimum is not the value at the point.
    #[error("the value is wrong")]
    Value,
    /// The objective does not fall along the direction.
    #[error("the objective does not fall without end")]
    NotFalling,
}

type Vector = [Rational; 3];

/// Checks an outcome, exactly. O(n).
///
/// # Errors
/// [`SpaceVerifyError`] says what is not proved.
pub fn verify(problem: &SpaceLadProblem, outcome: &SpaceOutcome) -> Result<(), SpaceVerifyError> {
    match outcome {
        SpaceOutcome::Optimal(optimum) => verify_optimum(problem, optimum),
        SpaceOutcome::Unbounded { direction } => {
            let start = dot(&problem.linear().map(rational), direction);
            let slope = (0..problem.planes().len()).fold(start, |sum, i| {
                let (normal, _) = term(problem, i);
                sum + absolute(dot(&normal, direction))
            });
            if slope < Rational::ZERO { Ok(()) } else { Err(SpaceVerifyError::NotFalling) }
        }
    }
}

fn verify_optimum(problem: &SpaceLadProblem, optimum: &SpaceOptimum) -> Result<(), SpaceVerifyError> {
    let SpaceOptimum { point, value, certificate } = optimum;
    let count = problem.planes().len();
    let basis: Vec<usize> = certificate.basis.iter().map(|&b| b as usize).collect();
    let is_basis = basis.len() <= 3 && basis.windows(2).all(|pair| pair[0] < pair[1]);
    if certificate.signs.len() != count || !is_basis || basis.iter().any(|&b| b >= count) {
        return Err(SpaceVerifyError::Shape);
    }
    let mut total = dot(&problem.linear().map(rational), point);
    let mut gradient = problem.linear().map(rational);
    for (plane, &sign) in certificate.signs.iter().enumerate() {
        let (normal, offset) = term(problem, plane);
        let at = dot(&normal, point) + offset;
        let in_basis = basis.contains(&plane);
        let agrees = match sign {
            0 => at == Rational::ZERO,
            1 => at >= Rational::ZERO && !in_basis,
            -1 => at <= Rational::ZERO && !in_basis,
            _ => false,
        };
        if !agrees {
            return Err(SpaceVerifyError::Sign { plane });
        }
        let sign = Rational::from(sign);
        gradient.iter_mut().zip(&normal).for_each(|(sum, v)| *sum += &sign * v);
        total += absolute(at);
    }
    if total != *value {
        return Err(SpaceVerifyError::Value);
    }
    // Gram's equations Σ_c (b · c) δ_c = −b · gradient, by Cramer's rule, then the residual.
    let normals: Vec<Vector> = basis.iter().map(|&b| term(problem, b).0).collect();
    let right: Vec<Rational> = normals.iter().map(|b| -dot(b, &gradient)).collect();
    let gram: Vec<Vec<Rational>> = normals.iter().map(|b| normals.iter().map(|c| dot(b, c)).collect()).collect();
    let whole = determinant(&gram);
    for (k, normal) in normals.iter().enumerate() {
        let mut replaced = gram.clone();
        replaced.iter_mut().zip(&right).for_each(|(row, r)| row[k] = r.clone());
        let part = determinant(&replaced);
        if whole == Rational::ZERO || absolute(part.clone()) > absolute(whole.clone()) {
            return Err(SpaceVerifyError::Subgradient);
        }
        let coefficient = part / &whole;
        gradient.iter_mut().zip(normal).for_each(|(sum, v)| *sum += &coefficient * v);
    }
    if gradient.iter().all(|v| *v == Rational::ZERO) { Ok(()) } else { Err(SpaceVerifyError::Subgradient) }
}

/// A plane's normal and offset times its weight.
fn term(problem: &SpaceLadProblem, plane: usize) -> (Vector, Rational) {
    let plane = problem.planes()[plane];
    let weight = rational(plane.weight);
    (plane.normal.map(|v| &weight * rational(v)), &weight * rational(plane.offset))
}

fn absolute(value: Rational) -> Rational {
    if value < Rational::ZERO { -value } else { value }
}

fn rational(value: f64) -> Rational {
    Dyadic::from_f64(value).to_rational()
}
