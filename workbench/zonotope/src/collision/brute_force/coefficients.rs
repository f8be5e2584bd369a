//! The coefficients of a member of a zonotope.

use super::span::{Span, dot};
use super::{Tightest, Vector};
use crate::collision::location::Witness;
use crate::collision::settling::settle;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// The witness of a member.
pub(super) fn witness(point: &Vector, generators: &[Vector]) -> Witness {
    settle(least(point, generators), |i| generators[i].iter().map(Dyadic::to_rational).collect())
}

/// Coefficients with Σ δ_i g_i = point whose largest magnitude is the gauge of the point, a point of the generators' span.
fn least(point: &Vector, generators: &[Vector]) -> Vec<Rational> {
    if point.iter().all(Dyadic::is_zero) {
        return vec![Rational::ZERO; generators.len()];
    }
    let span = Span::of(generators, point.len());
    let tightest = Tightest::of(&span.project(point), &span.project_all(generators));
    through_facet(&Tightest { normal: span.lift(&tightest.normal), ..tightest }, point, generators)
}

/// The same, given the normal of a facet of the zonotope's multiple that has the point on its boundary.
pub(in crate::collision) fn through_facet(facet: &Tightest, point: &Vector, generators: &[Vector]) -> Vec<Rational> {
    let Tightest { normal, along_point, along_zonotope } = facet;
    let gauge = along_point.to_rational() / along_zonotope.to_rational();
    // What the generators of the facet have to make up, times the denominator of the gauge, so that it stays dyadic.
    let mut left: Vector = point.iter().map(|v| v * along_zonotope).collect();
    let (mut coefficients, mut facet) = (vec![Rational::ZERO; generators.len()], Vec::new());
    for (i, generator) in generators.iter().enumerate() {
        let sign = dot(normal, generator).sign();
        if sign.is_eq() {
            facet.push(i);
            continue;
        }
        coefficients[i] = if sign.is_gt() { gauge.clone() } else { -&gauge };
        for (sum, v) in left.iter_mut().zip(generator) {
            let share = v * along_point;
            *sum = if sign.is_gt() { &*sum - &share } else { &*sum + &share };
        }
    }
    let in_facet: Vec<Vector> = facet.iter().map(|&i| generators[i].clone()).collect();
    let scale = along_zonotope.to_rational();
    for (&i, coefficient) in facet.iter().zip(least(&left, &in_facet)) {
        coefficients[i] = coefficient / &scale;
    }
    coefficients
}
