//! Checks an answer in exact arithmetic: that the zonogon contains the points, and that the bounds hold.
//!
//! The lower bound rests on three facts that anyone can recompute. (1) With e_t the edges of the hull, P_s the vertex farthest from
//! edge t and v_t(O) = e_t × (2O − P_s − P_t), the area of the smallest zonogon centred at O is f(O) = A + ½ Σ |v_t(O)|, A the area
//! of the hull. (2) For coefficients |δ_t| ≤ 1 with Σ δ_t e_t = 0 the sum Σ δ_t v_t(O) does not depend on O. (3) Hence
//! f(O) ≥ A + ½ Σ δ_t v_t(c) for every O and any c; here c is the centre of the answer.
//!
//! For (1): f grows by Σ max(0, v_t) from a constant, as [`bisectors`](crate::enclosing::bisectors) derives, and the constant is the
//! mixed area of the hull and its reflection, ½ Σ e_t × P_s. With Σ e_t = 0 and Σ P_t × e_t = 2A the sum of all v_t is
//! 2A − Σ e_t × P_s, so f = ½ Σ e_t × P_s + ½ Σ v_t + ½ Σ |v_t| = A + ½ Σ |v_t|.

use std::cmp::Ordering;

use thiserror::Error;

use super::answer::MinAreaZonogon;
use crate::hull::{self, ConvexHull};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// What is wrong with an answer.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MinAreaDefect {
    /// The hull is not the convex hull of the points.
    #[error("the hull is not that of the points: {0}")]
    Hull(hull::verify::HullDefect),
    /// A hull vertex lies outside the zonogon.
    #[error("hull vertex {0} lies outside the zonogon")]
    Outside(usize),
    /// The area is below that of the zonogon, or more than a relative 1e-12 above it.
    #[error("the area is not that of the zonogon")]
    Area,
    /// The certificate does not have a coefficient for each edge, or they do not sum to zero within [−1, 1].
    #[error("the coefficients prove nothing")]
    Certificate,
    /// The lower bound is above what the certificate proves.
    #[error("the lower bound is above what the certificate proves")]
    LowerBound,
    /// The area is above what the certificate proves by more than rounding.
    #[error("the area is above what the certificate proves by more than rounding")]
    NotLeast,
    /// At the optimal centre the certificate proves less than the area.
    #[error("the optimal centre is not optimal")]
    Center,
}

/// Checks hull, containment, area, lower bound and optimal centre, and that the area is the least possible within
/// 1e-12 of it and (2^-49 · largest coordinate + 2^-1068) · (width + height): the centre and the generators are doubles. The dimension of the set of
/// optimal centres is taken on trust. O(n log n) exact operations for n points.
///
/// # Errors
/// The first defect found.
pub fn verify(points: &[[f64; 2]], answer: &MinAreaZonogon) -> Result<(), MinAreaDefect> {
    hull::verify::verify(points, &answer.hull).map_err(MinAreaDefect::Hull)?;
    contains_hull(answer)?;
    let area = answer.zonogon.exact_area().to_rational();
    let reported = |value: f64| Dyadic::from_f64(value).to_rational();
    let denormal_step = reported(f64::from_bits(1));
    let tolerated = &area + &area / Rational::from(1_000_000_000_000u64) + denormal_step;
    let is_right = match answer.area {
        claimed if claimed.is_finite() => (&area..=&tolerated).contains(&&reported(claimed)),
        claimed => claimed == f64::INFINITY && tolerated > reported(f64::MAX),
    };
    if !is_right {
        return Err(MinAreaDefect::Area);
    }
    let proven = proven_lower_bound(answer)?;
    if !answer.lower_bound.is_finite() || reported(answer.lower_bound) > proven {
        return Err(MinAreaDefect::LowerBound);
    }
    if area - proven > tolerated / Rational::from(1_000_000_000_000u64) + rounding_allowance(answer.hull.vertices()) {
        return Err(MinAreaDefect::NotLeast);
    }
    Ok(())
}

/// (2^-49 · largest coordinate + 2^-1068) · (width + height).
fn rounding_allowance(vertices: &[[f64; 2]]) -> Rational {
    let exact = |v: f64| Dyadic::from_f64(v);
    let extent = |axis: usize| {
        let values = || vertices.iter().map(|vertex| vertex[axis]);
        exact(values().fold(f64::NEG_INFINITY, f64::max)) - exact(values().fold(f64::INFINITY, f64::min))
    };
    let largest = vertices.iter().flatten().fold(0.0f64, |largest, v| largest.max(v.abs()));
    let unit = exact(largest).scaled(-49) + exact(64.0 * f64::from_bits(1));
    (unit * (extent(0) + extent(1))).to_rational()
}

/// Walks around hull and zonogon together: over each edge of the zonogon no hull vertex is farther out.
fn contains_hull(answer: &MinAreaZonogon) -> Result<(), MinAreaDefect> {
    let zonogon = answer.zonogon.exact_vertices();
    let hull: Vec<_> = answer.hull.vertices().iter().map(|p| p.map(Dyadic::from_f64)).collect();
    if zonogon.len() < 3 {
        let outside = answer.hull.vertices().iter().position(|&p| !answer.zonogon.contains_by_vertices(p));
        return outside.map_or(Ok(()), |vertex| Err(MinAreaDefect::Outside(vertex)));
    }
    let next = |v: usize| (v + 1) % hull.len();
    let mut lowest: Option<usize> = None;
    for (a, b) in zonogon.iter().zip(zonogon.iter().cycle().skip(1)) {
        let edge = [&b[0] - &a[0], &b[1] - &a[1]];
        let height = |v: usize| &edge[0] * &(&hull[v][1] - &a[1]) - &edge[1] * &(&hull[v][0] - &a[0]);
        let mut vertex =
            lowest.unwrap_or_else(|| (0..hull.len()).min_by_key(|&v| height(v)).expect("a hull has vertices"));
        while height(next(vertex)) < height(vertex) {
            vertex = next(vertex);
        }
        if height(vertex).sign() == Ordering::Less {
            return Err(MinAreaDefect::Outside(vertex));
        }
        lowest = Some(vertex);
    }
    Ok(())
}

/// A + ½ Σ δ_t v_t(c) at the centre c of the answer, once the optimal centre has been found to be where δ_t v_t = |v_t| for all t.
fn proven_lower_bound(answer: &MinAreaZonogon) -> Result<Rational, MinAreaDefect> {
    let hull: Vec<[Rational; 2]> =
        answer.hull.vertices().iter().map(|p| p.map(|v| Dyadic::from_f64(v).to_rational())).collect();
    let center = answer.zonogon.center().map(|v| Dyadic::from_f64(v).to_rational());
    if !answer.hull.has_area() {
        return Ok(Rational::ZERO);
    }
    let coefficients = coefficients(answer, &hull)?;
    let farthest = farthest(&answer.hull);
    let values_at = |center: &[Rational; 2]| -> Vec<Rational> {
        let value = |t: usize| {
            let (from, edge, far) = (&hull[t], edge(&hull, t), &hull[farthest[t]]);
            let d = [0, 1].map(|i| &center[i] + &center[i] - &far[i] - &from[i]);
            &edge[0] * &d[1] - &edge[1] * &d[0]
        };
        (0..hull.len()).map(value).collect()
    };
    let [x, y, w] = answer.optimal_center.each_ref().map(|v| v.to_rational());
    if w == Rational::ZERO {
        return Err(MinAreaDefect::Center);
    }
    let is_attained = |(value, coefficient): (&Rational, &Rational)| {
        let size = if *value < Rational::ZERO { -value.clone() } else { value.clone() };
        coefficient * value == size
    };
    if !values_at(&[x / &w, y / w]).iter().zip(&coefficients).all(is_attained) {
        return Err(MinAreaDefect::Center);
    }
    let terms = values_at(&center).into_iter().zip(&coefficients).map(|(value, coefficient)| coefficient * value);
    let doubled = terms.fold(doubled_area(&hull), |sum, term| sum + term);
    Ok(doubled / Rational::from(2))
}

/// Twice the area of a polygon.
fn doubled_area(polygon: &[[Rational; 2]]) -> Rational {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).fold(Rational::ZERO, |sum, (a, b)| sum + &a[0] * &b[1] - &a[1] * &b[0])
}

/// The coefficients δ_t with those of the basis solved for.
fn coefficients(answer: &MinAreaZonogon, hull: &[[Rational; 2]]) -> Result<Vec<Rational>, MinAreaDefect> {
    let certificate = &answer.certificate;
    if certificate.signs.len() != hull.len() || certificate.signs.iter().any(|sign| sign.abs() > 1) {
        return Err(MinAreaDefect::Certificate);
    }
    let mut coefficients: Vec<Rational> = certificate.signs.iter().map(|&sign| Rational::from(sign)).collect();
    let [first, second] = certificate.basis[..] else { return Err(MinAreaDefect::Certificate) };
    let (first, second) = (first.position(), second.position());
    if first.max(second) >= hull.len()
        || coefficients[first] != Rational::ZERO
        || coefficients[second] != Rational::ZERO
    {
        return Err(MinAreaDefect::Certificate);
    }
    let mut rest = [Rational::ZERO, Rational::ZERO];
    for (t, coefficient) in coefficients.iter().enumerate() {
        let edge = edge(hull, t);
        rest = [&rest[0] - coefficient * &edge[0], &rest[1] - coefficient * &edge[1]];
    }
    let (a, b) = (edge(hull, first), edge(hull, second));
    let cross = |u: &[Rational; 2], v: &[Rational; 2]| &u[0] * &v[1] - &u[1] * &v[0];
    let determinant = cross(&a, &b);
    if determinant == Rational::ZERO {
        return Err(MinAreaDefect::Certificate);
    }
    coefficients[first] = cross(&rest, &b) / &determinant;
    coefficients[second] = cross(&a, &rest) / &determinant;
    let inside = |v: &Rational| (Rational::from(-1)..=Rational::ONE).contains(v);
    if coefficients.iter().all(inside) { Ok(coefficients) } else { Err(MinAreaDefect::Certificate) }
}

fn edge(hull: &[[Rational; 2]], t: usize) -> [Rational; 2] {
    let (from, to) = (&hull[t], &hull[(t + 1) % hull.len()]);
    [&to[0] - &from[0], &to[1] - &from[1]]
}

/// A farthest vertex of each edge, by walking on while vertices get higher.
fn farthest(hull: &ConvexHull) -> Vec<usize> {
    let exact: Vec<_> = hull.vertices().iter().map(|p| p.map(Dyadic::from_f64)).collect();
    let count = exact.len();
    let mut far = 1;
    (0..count)
        .map(|t| {
            let (a, b) = (&exact[t], &exact[(t + 1) % count]);
            let height = |v: usize| (&b[0] - &a[0]) * (&exact[v][1] - &a[1]) - (&b[1] - &a[1]) * (&exact[v][0] - &a[0]);
            while height((far + 1) % count) > height(far) {
                far = (far + 1) % count;
            }
            far
        })
        .collect()
}
