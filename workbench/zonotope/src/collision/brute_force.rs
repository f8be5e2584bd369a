//! Location and gauge of a displacement, from every facet normal: the truth, in exact arithmetic.
//!
//! # Statement
//! Input: a displacement p and generators g_i in R^D, any D ≥ 1. Output: where p lies relative to Z = { Σ δ_i g_i
//! : |δ_i| ≤ 1 }, and the gauge min { t ≥ 0 : p ∈ t Z }, exactly. Z is closed; a flat Z has no inside, so its points
//! are on the boundary, the origin of an empty Z included. The gauge of p = 0 is 0; off the span of the generators it
//! is infinite.
//!
//! # Source
//! None; Section 3 names the facets of a zonotope by sets of D − 1 generators.
//!
//! # Method
//! 1. Eliminate to find the span of the generators and coordinates ("axes") that determine a vector of the span. If p
//!    is off the span, a direction orthogonal to the span separates.
//! 2. In those coordinates Z has an interior. Each r − 1 independent generators of r = rank have one normal u; every
//!    facet normal is among these. The gauge is the largest |u · p| / Σ |u · g_i|, and its normal separates when it
//!    exceeds 1.
//! 3. A member p ≠ 0 of gauge t takes t · sign(u · g_i) off the facet; what is left lies in t times the zonotope of the
//!    generators in the facet, a problem of lower rank.
//! 4. Coefficients that are no doubles are moved along linear dependences until each has met ±1 or belongs to the
//!    basis.
//!
//! # Complexity
//! n = number of generators: O(n^D) exact operations for the normals, O(n D³) for the coefficients.
//!
//! # Shapes
//! generators: n × D, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Exact rationals throughout. Basis coefficients are rounded to nearest; a separating direction is rounded if the
//! rounded one still separates exactly.
//!
//! # Checked by
//! The crate `verifier`, and squares and cubes by hand.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, Status, brute_force};
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let question = Query::new([0.0, 0.0], [1.0, 0.25], &square).unwrap();
//! assert_eq!(brute_force::exact_gauge(&question), Some(1.into()));
//! assert_eq!(brute_force::locate(&question).status(), Status::Boundary);
//! ```

use std::cmp::Ordering;

use super::proof::tightest_facet::{TightestFacet, Vector, witness};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::Span;
use crate::zonotope::location::{Gauge, Location, Separation, Status};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

/// Where the displacement lies, with a proof.
#[inline(never)]
pub fn locate<const D: usize, P: Standing>(question: &Query<'_, D, P>) -> Location<D> {
    let (point, generators) = exactly(question);
    match side(&point, &generators, D) {
        Side::Beyond(direction) => Location::Outside(Separation::near(question, &array(direction))),
        Side::Inner => Location::Inside(witness(&point, &generators)),
        Side::Boundary => Location::Boundary(witness(&point, &generators)),
    }
}

/// The same without a proof, which takes longer to find than the status.
pub fn status<const D: usize, P: Standing>(question: &Query<'_, D, P>) -> Status {
    let (point, generators) = exactly(question);
    match side(&point, &generators, D) {
        Side::Beyond(_) => Status::Outside,
        Side::Inner => Status::Inside,
        Side::Boundary => Status::Boundary,
    }
}

/// The side of the boundary on which the displacement ends.
enum Side {
    /// Outside, with a direction that separates.
    Beyond(Vector),
    Inner,
    Boundary,
}

fn side(point: &Vector, generators: &[Vector], dimension: usize) -> Side {
    let span = Span::of(generators.iter().cloned(), dimension);
    if let Some(direction) = span.direction_to(point) {
        return Side::Beyond(direction);
    }
    let tightest = TightestFacet::within(&span, point, generators);
    match tightest.along_point.cmp(&tightest.along_zonotope) {
        Ordering::Greater => Side::Beyond(tightest.normal),
        Ordering::Less if span.rank() == dimension => Side::Inner,
        _ => Side::Boundary,
    }
}

/// The displacement and the generators where they stand.
fn exactly<const D: usize, P: Standing>(question: &Query<'_, D, P>) -> (Vector, Vec<Vector>) {
    (question.exact().to_vec(), question.exact_generators().map(|v| v.to_vec()).collect())
}

/// The gauge; `None` when it is infinite.
pub fn exact_gauge<const D: usize, P: Standing>(question: &Query<'_, D, P>) -> Option<Rational> {
    let (point, generators) = exactly(question);
    let span = Span::of(generators.iter().cloned(), D);
    if span.direction_to(&point).is_some() {
        return None;
    }
    let tightest = TightestFacet::within(&span, &point, &generators);
    Some(tightest.along_point.to_rational() / tightest.along_zonotope.to_rational())
}

/// The gauge, rounded, and the location.
#[inline(never)]
pub fn gauge<const D: usize, P: Standing>(question: &Query<'_, D, P>) -> Gauge<D> {
    let location = locate(question);
    let Some(exact) = exact_gauge(question) else { return Gauge { value: f64::INFINITY, error: 0.0, location } };
    let value = exact.to_f64().value().min(f64::MAX);
    let rounded = Dyadic::from_f64(value).to_rational();
    let error = if rounded > exact { rounded - exact } else { exact - rounded };
    let error = if error == Rational::ZERO { 0.0 } else { error.to_f64().value().next_up() };
    Gauge { value, error, location }
}

fn array<const D: usize>(vector: Vector) -> [Dyadic; D] {
    vector.try_into().expect("the vector has D coordinates")
}

#[cfg(test)]
mod tests;
