//! The coefficients of a member of a zonotope: exact ones first, then ones that a witness can say.

use super::span::{Span, dot};
use super::{Tightest, Vector};
use crate::collision::location::Witness;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// The witness of a member.
pub(super) fn witness(point: &Vector, generators: &[Vector]) -> Witness {
    let mut exact = least(point, generators);
    let basis = settle(&mut exact, generators);
    let coefficients = exact.iter().map(|c| c.to_f64().value().clamp(-1.0, 1.0)).collect();
    Witness { coefficients, basis }
}

/// Coefficients with Σ δ_i g_i = point whose largest magnitude is the gauge of the point, a point of the generators' span.
fn least(point: &Vector, generators: &[Vector]) -> Vec<Rational> {
    if point.iter().all(Dyadic::is_zero) {
        return vec![Rational::ZERO; generators.len()];
    }
    let span = Span::of(generators, point.len());
    let Tightest { normal, along_point, along_zonotope } =
        Tightest::of(&span.project(point), &span.project_all(generators));
    let normal = span.lift(&normal);
    let gauge = along_point.to_rational() / along_zonotope.to_rational();
    // What the generators of the facet have to make up, times the denominator of the gauge, so that it stays dyadic.
    let mut left: Vector = point.iter().map(|v| v * &along_zonotope).collect();
    let (mut coefficients, mut facet) = (vec![Rational::ZERO; generators.len()], Vec::new());
    for (i, generator) in generators.iter().enumerate() {
        let sign = dot(&normal, generator).sign();
        if sign.is_eq() {
            facet.push(i);
            continue;
        }
        coefficients[i] = if sign.is_gt() { gauge.clone() } else { -&gauge };
        for (sum, v) in left.iter_mut().zip(generator) {
            let share = v * &along_point;
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

/// Moves coefficients of [−1, 1] along dependences of the generators until those that no double says belong to independent
/// generators: the basis, which is returned.
fn settle(coefficients: &mut [Rational], generators: &[Vector]) -> Vec<usize> {
    let is_double = |c: &Rational| Dyadic::from_f64(c.to_f64().value()).to_rational() == *c;
    let mut basis: Vec<usize> = Vec::new();
    for i in 0..generators.len() {
        if is_double(&coefficients[i]) {
            continue;
        }
        basis.push(i);
        let members: Vec<&Vector> = basis.iter().map(|&b| &generators[b]).collect();
        let Some(dependence) = dependence(&members) else { continue };
        // The longest step in the direction of the dependence that stays in [−1, 1].
        let room = |(&b, rate): (&usize, &Rational)| {
            let end = if *rate > Rational::ZERO { Rational::ONE } else { Rational::NEG_ONE };
            (*rate != Rational::ZERO).then(|| (end - &coefficients[b]) / rate)
        };
        let step =
            basis.iter().zip(&dependence).filter_map(room).min().expect("a dependence has a member that is not 0");
        for (&b, rate) in basis.iter().zip(&dependence) {
            coefficients[b] += &step * rate;
        }
        basis.retain(|&b| !is_double(&coefficients[b]));
    }
    basis
}

/// The dependence of vectors all but the last of which are independent: Σ c_k vector_k = 0, c ≠ 0; `None` when all are.
fn dependence(vectors: &[&Vector]) -> Option<Vec<Rational>> {
    let count = vectors.len();
    let dimension = vectors.first().map_or(0, |v| v.len());
    // One row for each coordinate: the vectors are the columns.
    let mut rows: Vec<Vec<Rational>> =
        (0..dimension).map(|j| vectors.iter().map(|v| v[j].to_rational()).collect()).collect();
    for column in 0..count {
        let Some(found) = (column..dimension).find(|&row| rows[row][column] != Rational::ZERO) else {
            // Only the last column can be without a pivot.
            let mut dependence: Vec<Rational> = rows[..column].iter().map(|row| -&row[column]).collect();
            dependence.push(Rational::ONE);
            return Some(dependence);
        };
        rows.swap(column, found);
        let pivot = rows[column][column].clone();
        rows[column].iter_mut().for_each(|v| *v /= &pivot);
        let reduced = rows[column].clone();
        for row in rows.iter_mut().enumerate().filter(|(r, _)| *r != column).map(|(_, row)| row) {
            let factor = row[column].clone();
            row.iter_mut().zip(&reduced).for_each(|(a, b)| *a -= &factor * b);
        }
    }
    None
}
