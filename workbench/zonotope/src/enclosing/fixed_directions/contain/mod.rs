//! Stage: from a guess of centre and coefficients to a zonotope that contains every point, exactly.
//!
//! The centre is rounded to doubles first and not changed after that. For each point, coefficients δ_i in [−1, 1]
//! with Σ δ_i c_i v_i near point − p come from the facet through which its ray from the centre leaves. Some points are
//! missed by a little; then the coefficients c_i of a basis of directions are enlarged by the most that any point
//! misses along each of them.
//!
//! | file | what it does | for which points |
//! |---|---|---|
//! | `body` | the zonotope with a basis of directions and its inverse | |
//! | `clear` | proves a point inside by an error bound in doubles | nearly all |
//! | `missing` | the exact residual of the best coefficients | near the boundary |
//! | `thickened` | coefficients from zonotopes whose short generators are lengthened | of flat and needle-shaped bodies |
//! | `rational_coefficients` | coefficients by a linear program in rationals | where floating point finds none |
//! | `basis` | independent directions with long generators | |
//! | `flat_center` | a centre in doubles in the affine span of the points | of problems in a proper subspace |

mod basis;
mod body;
mod clear;
pub(super) mod flat_center;
mod missing;
mod rational_coefficients;
mod thickened;

use std::cell::Cell;

use super::answer::DirectedZonotope;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::scaled::Scaled;
use crate::enclosing::answer::Effort;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::numeric::outward::{at_least, fraction_at_least};
use crate::numeric::scaling::scale_by_power_of_two;
use crate::zonotope::ray_exit::{Exit, FacetMap};
use body::Body;
use thickened::Thickened;

/// A point is near the boundary if its ray leaves at a multiple of it that exceeds 1 by less than this; its residual is
/// computed exactly.
const BOUNDARY_REACH_MARGIN: f64 = 1e-9;

/// A generator shorter than this, relative to the longest, is left out; the enlarged coefficients of the others make up
/// for it.
const NEGLIGIBLE_LENGTH: f64 = 1e-14;

/// A zonotope that contains all points of a problem, and the points that it was enlarged for.
pub(super) struct Container<const D: usize> {
    /// The zonotope; its lower bound is yet to be filled in.
    pub(super) zonotope: DirectedZonotope<D>,
    /// For each coefficient that was enlarged a point for which it was enlarged by as much as for any other.
    pub(super) enlarged_for: Vec<usize>,
}

/// A zonotope with a given centre that contains every point, from a guess of its coefficients in scaled units: they are
/// enlarged where a point needs it. What exact numbers take is taken off `exact_work`; with none left the guess is
/// enlarged by what floating point leaves.
///
/// # Errors
/// When a coefficient exceeds the largest double.
pub(super) fn contain<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    center: [f64; D],
    coefficients: &[f64],
    map: &mut FacetMap<D>,
    exact_work: &Cell<u64>,
) -> Result<Container<D>, FixedDirectionsError> {
    let mut all = vec![0.0; problem.directions().len()];
    let units: Vec<i64> = scaled.directions.iter().map(|d| scaled.exponent - d.exponent).collect();
    let in_units = |c: &f64, unit: &i64| scale_by_power_of_two(c.max(0.0), *unit);
    let coefficients: Vec<f64> = coefficients.iter().zip(&units).map(|(c, u)| in_units(c, u)).collect();
    if coefficients.iter().any(|c| !c.is_finite()) {
        return Err(FixedDirectionsError::OutOfRange);
    }
    let body = Body::new(problem, scaled, center, without_negligible(scaled, coefficients), exact_work);
    let (enlargements, enlarged_for): (Vec<Rational>, Vec<Option<usize>>) =
        enlargements(&body, map).into_iter().unzip();
    let mut coefficients = body.coefficients;
    for (&b, enlargement) in body.basis.iter().zip(enlargements) {
        if !enlargement.is_zero() {
            let exact = Dyadic::from_f64(coefficients[b]).to_rational() + enlargement;
            coefficients[b] = fraction_at_least(&exact);
        }
    }
    for (direction, c) in scaled.directions.iter().zip(&coefficients) {
        if !c.is_finite() {
            return Err(FixedDirectionsError::OutOfRange);
        }
        all[direction.index] = *c;
    }
    let value = value_above(problem.weights(), &all);
    let (multipliers, effort) = (Vec::new(), Effort::default());
    let zonotope = DirectedZonotope { center, coefficients: all, value, lower_bound: 0.0, multipliers, effort };
    Ok(Container { zonotope, enlarged_for: enlarged_for.into_iter().flatten().collect() })
}

/// The coefficients, with 0 for generators that are negligible relative to the longest: they are rounding noise, which
/// hinders the search for a facet.
fn without_negligible<const D: usize>(scaled: &Scaled<D>, coefficients: Vec<f64>) -> Vec<f64> {
    let lengths = || {
        scaled
            .directions
            .iter()
            .map(|d| dot(&d.vector, &d.vector).sqrt() * scale_by_power_of_two(1.0, d.exponent - scaled.exponent))
    };
    let longest = lengths().zip(&coefficients).fold(0.0, |max: f64, (l, c)| max.max(l * c));
    let kept = |(l, c): (f64, f64)| if l * c < NEGLIGIBLE_LENGTH * longest { 0.0 } else { c };
    lengths().zip(coefficients).map(kept).collect()
}

/// For each direction of the basis the enlargement of its coefficient with which every point is inside, and the first
/// point that needs all of it, if it is not zero.
fn enlargements<const D: usize>(body: &Body<'_, D>, map: &mut FacetMap<D>) -> Vec<(Rational, Option<usize>)> {
    let rank = body.scaled.rank;
    let mut enlargements = vec![(Rational::ZERO, None); rank];
    let basis = body.basis.iter().map(|&b| (b, body.scaled.directions[b].vector));
    let mut thickened = Thickened::new(rank, &body.generators, basis);
    let extents: [f64; D] = std::array::from_fn(|c| body.generators.iter().map(|g| g[c].abs()).sum());
    let inside: Vec<f64> = (0..body.generators.len()).map(|i| body.coefficient(i)).collect();
    map.set_coefficients(&inside);
    let inverse_error = body.basis_inverse_error();
    for (j, point) in body.problem.points().iter().enumerate() {
        let q: [f64; D] = std::array::from_fn(|i| {
            body.scaled.coordinates.get(i).map_or(0.0, |&c| body.scaled.difference(point[c], body.center[c]))
        });
        let is_clear = |exit: Exit<D>, error: f64| {
            exit.reach > 1.0 + BOUNDARY_REACH_MARGIN && body.is_clear(&q, &exit, &extents, error)
        };
        if inverse_error.is_some_and(|error| map.exit(&q).is_some_and(|exit| is_clear(exit, error))) {
            continue;
        }
        let missing = body.least_missing(point, &q, &mut thickened);
        for (more, need) in enlargements.iter_mut().zip(missing) {
            if need > more.0 {
                *more = (need, Some(j));
            }
        }
    }
    enlargements
}

/// The value Σ w_i c_i, rounded up; infinite above the largest double.
pub(crate) fn value_above(weights: &[f64], coefficients: &[f64]) -> f64 {
    let sum = weights.iter().zip(coefficients).fold(Dyadic::zero(), |sum, (&w, &c)| {
        if w == 0.0 || c == 0.0 { sum } else { sum + &Dyadic::from_f64(w) * &Dyadic::from_f64(c) }
    });
    at_least(&sum)
}
