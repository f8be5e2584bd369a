//! The facet that bounds a gauge, and the coefficients of a point on it: by recursion on the facets of facets.
//!
//! A facet holds the generators orthogonal to its normal; off it, each takes the coefficient with which it reaches
//! farthest. What these leave of the point is a point of the facet, a problem of one dimension less.

use super::to_doubles::rounded_off_a_basis;
use crate::collision::Witness;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, hyperplane_normal, sum_of_products};
use crate::numeric::subsets::for_each_subset;

/// A vector of exact coordinates, as many as the space at hand has.
pub(in crate::collision) type Vector = Vec<Dyadic>;

/// The normal that bounds the gauge from below best, with the support values on both sides.
pub(in crate::collision) struct TightestFacet {
    pub(in crate::collision) normal: Vector,
    /// normal · p, not negative.
    pub(in crate::collision) along_point: Dyadic,
    /// Σ |normal · g_i|, positive.
    pub(in crate::collision) along_zonotope: Dyadic,
}

impl TightestFacet {
    /// The facet of generators that span the space, by trying the normal of each r − 1 of them. In no dimension the
    /// gauge is 0.
    pub(in crate::collision) fn of(point: &[Dyadic], generators: &[Vector]) -> Self {
        let rank = point.len();
        let mut best: Option<Self> = None;
        for_each_subset(generators.len(), rank.saturating_sub(1), |subset| {
            let members: Vec<&Vector> = subset.iter().map(|&i| &generators[i]).collect();
            let normal = hyperplane_normal(&members);
            if rank == 0 || normal.iter().all(Dyadic::is_zero) {
                return;
            }
            let along = sum_of_products(&normal, point);
            let total = generators.iter().fold(Dyadic::zero(), |sum, g| sum + sum_of_products(&normal, g).abs());
            let positive = along.clone().abs();
            if best.as_ref().is_none_or(|best| &positive * &best.along_zonotope > &best.along_point * &total) {
                let normal = if along.sign().is_lt() { normal.into_iter().map(|v| -v).collect() } else { normal };
                best = Some(Self { normal, along_point: positive, along_zonotope: total });
            }
        });
        best.unwrap_or_else(|| Self {
            normal: vec![Dyadic::zero(); rank],
            along_point: Dyadic::zero(),
            along_zonotope: Dyadic::one(),
        })
    }

    /// The facet of generators within their span, which holds the point, as one of the whole space.
    pub(in crate::collision) fn within(span: &Span, point: &[Dyadic], generators: &[Vector]) -> Self {
        let inside: Vec<Vector> = generators.iter().map(|g| span.project(g)).collect();
        let facet = Self::of(&span.project(point), &inside);
        Self { normal: span.embed(&facet.normal), ..facet }
    }

    /// Coefficients with Σ δ_i g_i = point whose largest magnitude is the gauge of the point, this being the facet of
    /// the zonotope's multiple that has the point on its boundary.
    pub(in crate::collision) fn coefficients(&self, point: &[Dyadic], generators: &[Vector]) -> Vec<Rational> {
        let Self { normal, along_point, along_zonotope } = self;
        let gauge = along_point.to_rational() / along_zonotope.to_rational();
        // The part that the generators of the facet have to make up, times the denominator of the gauge, so that it
        // stays dyadic.
        let mut left: Vector = point.iter().map(|v| v * along_zonotope).collect();
        let (mut coefficients, mut facet) = (vec![Rational::ZERO; generators.len()], Vec::new());
        for (i, generator) in generators.iter().enumerate() {
            let sign = sum_of_products(normal, generator).sign();
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
        for (&i, coefficient) in facet.iter().zip(smallest_coefficients(&left, &in_facet)) {
            coefficients[i] = coefficient / &scale;
        }
        coefficients
    }
}

/// The witness of a member.
pub(in crate::collision) fn witness(point: &[Dyadic], generators: &[Vector]) -> Witness {
    let coefficients = smallest_coefficients(point, generators);
    rounded_off_a_basis(coefficients, |i| generators[i].iter().map(Dyadic::to_rational).collect())
}

/// Coefficients with Σ δ_i g_i = point whose largest magnitude is the gauge of the point, a point of the generators'
/// span.
fn smallest_coefficients(point: &[Dyadic], generators: &[Vector]) -> Vec<Rational> {
    if point.iter().all(Dyadic::is_zero) {
        return vec![Rational::ZERO; generators.len()];
    }
    let span = Span::of(generators.iter().cloned(), point.len());
    TightestFacet::within(&span, point, generators).coefficients(point, generators)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::rational;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn vector(v: &[f64]) -> Vector {
        v.iter().map(|c| Dyadic::from_f64(*c)).collect()
    }

    #[test]
    fn the_facet_of_a_box_worked_out_by_hand() {
        let sides = [vector(&[2.0, 0.0, 0.0]), vector(&[0.0, 4.0, 0.0]), vector(&[0.0, 0.0, -1.0])];
        for (p, gauge, axis) in [([1.0, 1.0, -0.25], 0.5, 0), ([1.0, -3.0, 0.25], 0.75, 1), ([0.0, 0.0, 2.0], 2.0, 2)] {
            let facet = TightestFacet::of(&vector(&p), &sides);
            assert_eq!(facet.along_point.to_rational() / facet.along_zonotope.to_rational(), rational(gauge), "{p:?}");
            assert!(facet.normal.iter().enumerate().all(|(k, c)| c.is_zero() == (k != axis)), "{p:?}");
            assert_eq!(sum_of_products(&facet.normal, &vector(&p)), facet.along_point);
            assert!(facet.along_point.sign().is_gt());
        }
        // in no dimension there is nothing to bound
        let none = TightestFacet::of(&[], &[]);
        assert!(none.normal.is_empty() && none.along_point.is_zero() && none.along_zonotope == Dyadic::one());
    }

    /// The coefficients combine to the point, and the largest of them is the gauge that the facet tells.
    #[test]
    fn coefficients_are_at_most_the_gauge_and_combine_to_the_point() {
        let random = &mut Pcg64Mcg::seed_from_u64(161);
        for round in 0..120 {
            let n = 3 + round % 5;
            let mut draw = || [0, 1, 2].map(|_| f64::from(random.random_range(-3..4)));
            let mut rows: Vec<Vector> = (0..n).map(|_| vector(&draw())).collect();
            rows.extend([vector(&[1.0, 0.0, 0.0]), vector(&[0.0, 2.0, 0.0]), vector(&[0.0, 0.0, 1.0])]);
            let p = vector(&draw());
            if p.iter().all(Dyadic::is_zero) {
                continue;
            }
            let facet = TightestFacet::of(&p, &rows);
            let gauge = facet.along_point.to_rational() / facet.along_zonotope.to_rational();
            for own in [facet.coefficients(&p, &rows), smallest_coefficients(&p, &rows)] {
                assert_eq!(own.len(), rows.len());
                let largest = own.iter().map(|c| if *c < Rational::ZERO { -c } else { c.clone() }).max();
                assert_eq!(largest, Some(gauge.clone()), "{rows:?} {p:?}");
                for k in 0..3 {
                    let sum = rows.iter().zip(&own).fold(Rational::ZERO, |sum, (v, c)| sum + c * v[k].to_rational());
                    assert_eq!(sum, p[k].to_rational(), "{rows:?} {p:?}");
                }
            }
        }
    }
}
