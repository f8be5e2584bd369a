//! Checks an answer in exact arithmetic, with code that shares nothing with the methods.
//!
//! The lower bound rests on multipliers λ_j with Σ λ_j = 0 and Σ_j |λ_j · v_i| ≤ w_i ([`Multiplier`](super::Multiplier)); an infeasible problem on a functional that vanishes on
//! the directions but not on a difference of two points. Containment is decided for each point by the rational program
//! max { t : Σ δ_i c_i v_i = t (point − p), |δ_i| ≤ 1 } ≥ 1.

use thiserror::Error;

use super::answer::{DirectedZonotope, Enclosure, OffSpan};
use super::problem::FixedDirections;
use super::rational::simplex::{Column, maximize};
use super::span::rational;
use crate::numeric::Rational;
use crate::numeric::linear::sum_of_products;

/// What is wrong with an answer.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FixedDirectionsDefect {
    /// A coefficient is negative or not finite, or there is not one for each direction.
    #[error("the coefficients are not one number ≥ 0 for each direction")]
    Coefficients,
    /// A point lies outside the zonotope.
    #[error("point {0} lies outside the zonotope")]
    Outside(usize),
    /// The value is below Σ w_i c_i, or more than a relative 1e-12 above it.
    #[error("the value is not that of the coefficients")]
    Value,
    /// The multipliers do not add up to zero, or load a direction beyond its weight.
    #[error("the multipliers prove nothing")]
    Multipliers,
    /// The lower bound is above what the multipliers prove.
    #[error("the lower bound is above what the multipliers prove")]
    LowerBound,
    /// The functional does not separate the two points from the span.
    #[error("the functional does not prove that the points are out of reach")]
    OffSpan,
}

/// Checks everything about an answer. A rational program of k unknowns for each point: for small problems.
///
/// # Errors
/// The first defect found.
pub fn verify<const D: usize>(
    problem: &FixedDirections<'_, D>,
    answer: &Enclosure<D>,
) -> Result<(), FixedDirectionsDefect> {
    match answer {
        Enclosure::Infeasible(proof) => verify_off_span(problem, proof),
        Enclosure::Optimal(zonotope) => {
            verify_bounds(problem, zonotope)?;
            let inside = |j: usize| contains(problem, zonotope.center, &zonotope.coefficients, j);
            let outside = (0..problem.points().len()).find(|&j| !inside(j));
            outside.map_or(Ok(()), |point| Err(FixedDirectionsDefect::Outside(point)))
        }
    }
}

/// Checks value and lower bound, but not that the points are inside: O(k) exact operations for each multiplier.
///
/// # Errors
/// The first defect found.
pub fn verify_bounds<const D: usize>(
    problem: &FixedDirections<'_, D>,
    zonotope: &DirectedZonotope<D>,
) -> Result<(), FixedDirectionsDefect> {
    let coefficients = &zonotope.coefficients;
    if coefficients.len() != problem.directions().len() || coefficients.iter().any(|c| !c.is_finite() || *c < 0.0) {
        return Err(FixedDirectionsDefect::Coefficients);
    }
    let terms = problem.weights().iter().zip(coefficients).map(|(&w, &c)| rational(w) * rational(c));
    let value = terms.fold(Rational::ZERO, |sum, term| sum + term);
    let tolerated = &value + &value / Rational::from(1_000_000_000_000u64) + rational(f64::from_bits(1));
    if !zonotope.value.is_finite() || !(value..=tolerated).contains(&rational(zonotope.value)) {
        return Err(FixedDirectionsDefect::Value);
    }
    let mut sum: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
    let mut bound = Rational::ZERO;
    for multiplier in &zonotope.multipliers {
        let point = problem.points().get(multiplier.point).ok_or(FixedDirectionsDefect::Multipliers)?;
        bound += sum_of_products(&multiplier.vector, &point.map(rational));
        sum = std::array::from_fn(|c| &sum[c] + &multiplier.vector[c]);
    }
    if sum.iter().any(|c| !c.is_zero()) {
        return Err(FixedDirectionsDefect::Multipliers);
    }
    for (v, &weight) in problem.directions().iter().zip(problem.weights()) {
        let v = v.map(rational);
        let load = zonotope
            .multipliers
            .iter()
            .fold(Rational::ZERO, |load, multiplier| load + absolute(sum_of_products(&multiplier.vector, &v)));
        if load > rational(weight) {
            return Err(FixedDirectionsDefect::Multipliers);
        }
    }
    if rational(zonotope.lower_bound) > bound { Err(FixedDirectionsDefect::LowerBound) } else { Ok(()) }
}

fn verify_off_span<const D: usize>(
    problem: &FixedDirections<'_, D>,
    proof: &OffSpan<D>,
) -> Result<(), FixedDirectionsDefect> {
    let vanishes = problem.directions().iter().all(|v| sum_of_products(&proof.functional, &v.map(rational)).is_zero());
    let height = |j: usize| problem.points().get(j).map(|p| sum_of_products(&proof.functional, &p.map(rational)));
    let [a, b] = proof.points.map(height);
    if vanishes && a.is_some() && b.is_some() && a != b { Ok(()) } else { Err(FixedDirectionsDefect::OffSpan) }
}

/// Whether a point of the problem lies in the zonotope { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 }, exactly.
pub fn contains<const D: usize>(
    problem: &FixedDirections<'_, D>,
    center: [f64; D],
    coefficients: &[f64],
    point: usize,
) -> bool {
    let point = problem.points()[point].map(rational);
    let center = center.map(rational);
    if point == center {
        return true;
    }
    let used: Vec<[Rational; D]> = problem
        .directions()
        .iter()
        .zip(coefficients)
        .filter(|(_, c)| **c > 0.0)
        .map(|(v, &c)| v.map(|v| rational(v) * rational(c)))
        .collect();
    let mut columns = Vec::with_capacity(2 * used.len() + 1);
    for (i, generator) in used.iter().enumerate() {
        for sign in [Rational::ONE, -Rational::ONE] {
            let mut inequalities = vec![Rational::ZERO; used.len()];
            inequalities[i] = Rational::ONE;
            let equalities = generator.iter().map(|g| g * &sign).collect();
            columns.push(Column { inequalities, equalities, gain: Rational::ZERO });
        }
    }
    let back = point.iter().zip(&center).map(|(p, c)| c - p).collect();
    columns.push(Column { inequalities: vec![Rational::ZERO; used.len()], equalities: back, gain: Rational::ONE });
    let farthest = maximize(&columns, &vec![Rational::ONE; used.len()], D);
    farthest.is_none_or(|optimum| optimum.value >= Rational::ONE)
}

fn absolute(value: Rational) -> Rational {
    if value < Rational::ZERO { -value } else { value }
}
