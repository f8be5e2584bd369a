//! The proof of a member below the facet of two generators in pairs of doubles, where doubles leave a doubt of it.
//!
//! Of the normal of two generators that are nearly parallel doubles know few digits, and near the boundary so they do
//! of the coefficients. Pairs of doubles know twice as many of both: of the signs that are in doubt, of the factor, and
//! of what the basis makes up for.

use std::cmp::Ordering;

use super::three_coefficients::cross_terms;
use crate::lad::of_generators::optimum::Told;
use crate::numeric::combined_sum::combined_sum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{cross, cyclic_cross_products, dot};
use crate::numeric::tolerance::{DETERMINANT_OF_ROWS, PRODUCT_UNDERFLOW};
use crate::zonotope::query::Query;

type Vector = [BoundedDoubleDouble; 3];

/// The proof with three generators for a basis, the first two of which span the facet with the computed normal u; the
/// others have shares in [−1, 1], signs mostly. O(n).
pub(super) fn combined_in_pairs(
    query: &Query<'_, 3>,
    basis: [usize; 3],
    u: &[f64; 3],
    shares: &mut [f64],
) -> Option<Told> {
    let of = BoundedDoubleDouble::exact;
    let [a, b, c] = basis.map(|i| query.generator(i).map(of));
    let (from, to) = (query.from(), query.to());
    let p = [0, 1, 2].map(|k| of(to[k]) - of(from[k]));
    let computed = cross(&a, &b);
    let is_reversed = dot(&computed, &p).sign()? < 0;
    let area = cross_terms(&query.generator(basis[0]), &query.generator(basis[1]));
    for (i, v) in query.generators().enumerate() {
        let is_certain = dot(v, u).abs() > DETERMINANT_OF_ROWS * dot(&v.map(f64::abs), &area) + PRODUCT_UNDERFLOW;
        if is_certain || basis.contains(&i) || shares[i].abs() < 1.0 {
            continue;
        }
        if let Some(sign @ (1 | -1)) = dot(&computed, &v.map(of)).sign() {
            shares[i] = f64::from(if is_reversed { -sign } else { sign });
        }
    }
    let mut coefficients = shares.to_vec();
    coefficients[basis[0]] = 0.0;
    coefficients[basis[1]] = 0.0;
    let reach = dot(&computed, &sum(query, &coefficients));
    let factor = (dot(&computed, &p) / reach).high;
    // false for NaN as well
    let is_member = factor < 1.0;
    if !is_member {
        return None;
    }
    coefficients[basis[2]] = 0.0;
    coefficients.iter_mut().for_each(|coefficient| *coefficient *= factor);
    let off = sum(query, &coefficients);
    let own = solve([&a, &b, &c], &[p[0] - off[0], p[1] - off[1], p[2] - off[2]])?;
    for (coefficient, i) in own.into_iter().zip(basis) {
        coefficients[i] = coefficient;
    }
    Some(Told::combined(coefficients, basis))
}

/// Σ c v.
fn sum(query: &Query<'_, 3>, coefficients: &[f64]) -> Vector {
    let [first, second] = query.rows().map(Rows::list);
    let (own, others) = coefficients.split_at(first.len());
    let (own, others) = (combined_sum(first, own), combined_sum(second, others));
    [own[0] + others[0], own[1] + others[1], own[2] + others[2]]
}

/// The coefficients of three vectors that make up a rest, if they are certainly within (−1, 1).
fn solve([a, b, c]: [&Vector; 3], rest: &Vector) -> Option<[f64; 3]> {
    let normals = cyclic_cross_products(a, b, c);
    let determinant = dot(c, &normals[2]);
    determinant.sign()?;
    let mut coefficients = [0.0; 3];
    for (coefficient, normal) in coefficients.iter_mut().zip(&normals) {
        let numerator = dot(rest, normal);
        if numerator.abs().certain_order(&determinant.abs()) != Some(Ordering::Less) {
            return None;
        }
        *coefficient = (numerator.high / determinant.high).clamp(-1.0, 1.0);
    }
    Some(coefficients)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::collision::by_lad::proof::of_told;
    use crate::interop::verifier::check_location;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn members_near_a_facet_of_nearly_parallel_generators_are_proved() {
        let random = &mut Pcg64Mcg::seed_from_u64(6);
        let mut proved = 0;
        for _ in 0..60 {
            let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
            let a = vector(1.0);
            let (tiny, direction) = (vector(1e-9), vector(1.0));
            let b = [0, 1, 2].map(|k| a[k] + tiny[k]);
            let body = [a, b, vector(1.0), vector(1.0), vector(1.0)];
            let gauge = brute_force::gauge(&Query::new([0.0; 3], direction, &body).expect("finite")).value;
            let p = direction.map(|c| c * ((1.0 - 1e-12) / gauge));
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            for (i, j) in (0..5).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let u = cross(&body[i], &body[j]);
                let height = |k: &usize| dot(&body[*k], &u).abs();
                let others = (0..5).filter(|k| *k != i && *k != j);
                let third = others.max_by(|k, l| height(k).total_cmp(&height(l))).expect("there are three");
                let sign = f64::copysign(1.0, dot(&u, &p));
                let u = u.map(|c| sign * c);
                let mut shares = body.map(|v| f64::copysign(1.0, dot(&v, &u)));
                if let Some(told) = combined_in_pairs(&query, [i, j, third], &u, &mut shares) {
                    let location = of_told(told, &mut ());
                    assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
                    proved += 1;
                }
            }
        }
        assert!(proved >= 55, "{proved}");
    }
}
