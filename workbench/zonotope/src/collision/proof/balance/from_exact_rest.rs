//! The coefficients of a basis from the exact rest that all coefficients leave, in pairs of doubles.
//!
//! A coefficient of a basis that is nearly 0 is not known to the last place from a rest that was summed up to twice the
//! digits of a double. The exact rest is nearly as quick: most coefficients of a proof near the boundary are ±c for one
//! c, so that their vectors are summed up with signs alone. The rest is tiny, and pairs of doubles solve for the
//! corrections.

use std::array;

use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, exact, sum};
use crate::numeric::exact_product::exact_product;
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::linear::{cross, dot};
use crate::numeric::scaling::power_of_two;
use crate::numeric::signed_sum::signed_sum;
use crate::zonotope::location::Witness;
use crate::zonotope::pose::Standing;
use crate::zonotope::query::{Placed, Query, padded};

/// Magnitudes of products of doubles that are two doubles, without error.
const EXACT_PRODUCTS: std::ops::Range<f64> = power_of_two(-900)..power_of_two(900);

/// The coefficients of a basis of space, each the nearest double, if pairs of doubles tell all of them.
pub(super) fn nearest<P: Standing>(query: &Query<'_, 3, P>, witness: &Witness) -> Option<Vec<f64>> {
    let basis: [usize; 3] = witness.basis.as_slice().try_into().ok()?;
    let [a, b, c] = basis.map(|index| {
        let (body, v) = query.located(index);
        body.pair_image(v.map(BoundedDoubleDouble::exact))
    });
    let normals = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
    let determinant = dot(&a, &normals[0]);
    determinant.sign()?;
    let rest = rest(query, &witness.coefficients).each_ref().map(BoundedDoubleDouble::of);
    let own = |(index, normal): (usize, &[BoundedDoubleDouble; 3])| {
        let value = BoundedDoubleDouble::exact(witness.coefficients[index]) + dot(&rest, normal) / determinant;
        value.nearest_double()
    };
    basis.into_iter().zip(&normals).map(own).collect()
}

/// p − Σ c v over all generators, exactly. O(n).
fn rest<P: Standing>(query: &Query<'_, 3, P>, coefficients: &[f64]) -> ExactVector {
    let [first, second] = query.parts();
    let (own, others) = coefficients.split_at(first.generators().len());
    let [own, others] = [(first, own), (second, others)].map(|(body, own)| body.exact_image(combined(body, own)));
    let p = query.exact();
    array::from_fn(|k| &p[k] - &(&own[k] + &others[k]))
}

/// Σ c v over the generators of a body as they are stored, exactly. O(n).
fn combined<P: Standing>(body: &Placed<'_, 3, P>, coefficients: &[f64]) -> ExactVector {
    let mut neighbours = coefficients.windows(2);
    let common = neighbours.find(|pair| pair[0].abs() == pair[1].abs()).map_or(1.0, |pair| pair[0].abs());
    let terms = || body.generators().iter().zip(coefficients);
    let signed = signed_sum(terms().map(|(v, c)| {
        let sign = if c.abs() == common { 1f64.copysign(*c) as i8 } else { 0 };
        (padded(v), sign)
    }));
    let mut others: [ExactSum; 3] = Default::default();
    let mut small: ExactVector = exact([0.0; 3]);
    for (v, c) in terms().filter(|(_, c)| c.abs() != common && **c != 0.0) {
        for k in 0..3 {
            let (head, tail) = exact_product(*c, v[k]);
            if EXACT_PRODUCTS.contains(&head.abs()) {
                others[k].add(head);
                others[k].add(tail);
            } else {
                small[k] = &small[k] + &(&Dyadic::from_f64(*c) * &Dyadic::from_f64(v[k]));
            }
        }
    }
    let common = Dyadic::from_f64(common);
    let signed = signed.each_ref().map(|c| c * &common);
    sum(&sum(&signed, &others.each_ref().map(ExactSum::value)), &small)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Coefficients of one magnitude or of any, of bodies of ordinary, tiny and huge coordinates, at rest and turned.
    #[test]
    fn the_rest_is_the_displacement_less_all_terms() {
        let random = &mut Pcg64Mcg::seed_from_u64(66);
        for round in 0..60 {
            let scale = [1.0, 1e-310, 1e300][round % 3];
            let n = 1 + round % 9;
            let mut vector = || [0, 1, 2].map(|_| scale * random.random_range(-1.0..1.0f64));
            let rows: Vec<[f64; 3]> = (0..n).map(|_| vector()).collect();
            let body = Zonotope::new([0.0; 3], rows.clone()).expect("finite");
            let pose = Pose::from_axis_angle([1.0, 2.0, 3.0], 1.0, vector()).expect("an axis");
            let query = Query::of_placed(body.at(&Pose::IDENTITY), body.at(&pose));
            let coefficients: Vec<f64> = (0..2 * n)
                .map(|i| match (i + round) % 4 {
                    0 | 1 => 0.75f64.copysign(random.random_range(-1.0..1.0)),
                    2 => random.random_range(-1.0..1.0),
                    _ => [0.0, -1.0, 5e-324][i % 3],
                })
                .collect();
            let p = query.exact();
            for (k, own) in rest(&query, &coefficients).into_iter().enumerate() {
                let sum = coefficients.iter().enumerate().fold(Dyadic::zero(), |sum, (i, c)| {
                    let (body, v) = query.located(i);
                    sum + Dyadic::from_f64(*c) * body.exact_image(v.map(Dyadic::from_f64))[k].clone()
                });
                assert_eq!(own, p[k].clone() - sum, "{rows:?} {coefficients:?}");
            }
        }
    }

    #[test]
    fn a_coefficient_near_zero_is_the_nearest_double() {
        let random = &mut Pcg64Mcg::seed_from_u64(67);
        let mut known = 0;
        for _ in 0..200 {
            let rows: Vec<[f64; 3]> = (0..9).map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0))).collect();
            let coefficients: Vec<f64> =
                (0..9).map(|i| if i == 1 { 0.0 } else { 0.875f64.copysign(random.random_range(-1.0..1.0)) }).collect();
            let p = rows.iter().zip(&coefficients).fold([0.0; 3], |p, (v, c)| [0, 1, 2].map(|k| p[k] + c * v[k]));
            let query = Query::new([0.0; 3], p, &rows).expect("finite");
            let witness = Witness { coefficients, basis: vec![0, 1, 2] };
            let Some(own) = nearest(&query, &witness) else { continue };
            known += 1;
            let exact = super::super::nearest::exact_basis(&query, &witness).expect("the rows are independent");
            assert!(own[1].abs() < 1e-9);
            assert_eq!(own, exact.iter().map(|value| value.to_f64().value()).collect::<Vec<_>>());
        }
        assert!(known > 190, "{known}");
    }
}
