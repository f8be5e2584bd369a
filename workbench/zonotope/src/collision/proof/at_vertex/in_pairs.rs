//! The proof of a location by the facet that two generators span, where doubles leave a doubt of it.
//!
//! Of the normal of two generators that are nearly parallel, or of very different lengths, doubles know few digits, and
//! near the boundary so they do of the coefficients. Pairs of doubles know twice as many of both: of the signs that are
//! in doubt, of the sum of all generators but the two, whose products with the normal are zero and not what rounding
//! makes of them, and of what the basis makes up for.

use crate::collision::proof::balance::choice::{farthest_from_plane, well_spread};
use crate::collision::proof::balance::triple::Triple;
use crate::collision::proof::direction_of_doubles::{Beyond, Pairs};
use crate::lad::of_generators::told::Told;
use crate::numeric::bounded;
use crate::numeric::combined_sum::combined_sum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, exact};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{cross, dot};
use crate::zonotope::location::Separation;
use crate::zonotope::query::Query;

/// Where p lies, with its proof, from the computed normal u of two generators, which is a × b or, if it is reversed,
/// its opposite, and the signs of the products of all others with u, or shares in [−1, 1]. O(n).
pub(super) fn location_in_pairs(
    query: &Query<'_, 3>,
    pair: [usize; 2],
    u: &[f64; 3],
    is_reversed: bool,
    shares: &[f64],
) -> Option<Told> {
    let of = |v: [f64; 3]| v.map(BoundedDoubleDouble::exact);
    let (from, to) = (of(query.from()), of(query.to()));
    let p = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    let spanning = pair.map(|i| of(query.generator(i)));
    let computed = cross(&spanning[0], &spanning[1]);
    let normal = if is_reversed { computed.map(BoundedDoubleDouble::negated) } else { computed };
    let [a, b] = pair.map(|i| bounded::exact(query.generator(i)));
    let rounded = bounded::cross(&a, &b);
    let mut coefficients = shares.to_vec();
    // at most by so much is Σ |v · n| larger than n · S, as some signs are not certain
    let mut doubt = BoundedDoubleDouble::exact(0.0);
    for (i, v) in query.generators().enumerate() {
        let is_certain = dot(&bounded::exact(*v), &rounded).sign().is_some();
        if pair.contains(&i) {
            coefficients[i] = 0.0;
        } else if !is_certain || shares[i].abs() < 1.0 {
            let product = dot(&normal, &of(*v));
            match product.sign() {
                Some(sign) if shares[i].abs() == 1.0 => coefficients[i] = f64::from(sign),
                _ => doubt = doubt + product.largest(),
            }
        }
    }
    let sum = combined(query, &coefficients);
    let (along, reach) = (dot(&normal, &p), dot(&normal, &sum));
    if (along - reach - doubt - doubt).sign() == Some(1) {
        let beyond = Beyond { normal, rest: [p[0] - sum[0], p[1] - sum[1], p[2] - sum[2]], spanning };
        return Some(Told::Beyond(separation(query, &beyond, pair, is_reversed)));
    }
    let factor = (along / reach).high;
    coefficients.iter_mut().for_each(|coefficient| *coefficient *= factor);
    // false for NaN as well
    let is_member = factor < 1.0;
    if is_member { member(query, &p, pair, u, coefficients) } else { None }
}

/// The direction of the facet, which separates: in doubles, if that is found to separate as well.
fn separation(query: &Query<'_, 3>, beyond: &Beyond, pair: [usize; 2], is_reversed: bool) -> Separation<3> {
    if let Some(direction) = beyond.direction_of_doubles(query) {
        return Separation::Rounded(direction);
    }
    let [a, b] = pair.map(|i| exact(query.generator(i)));
    let normal = if is_reversed { exact_linear::cross(&b, &a) } else { exact_linear::cross(&a, &b) };
    Separation::Exact(Box::new(normal.map(|c| c.to_rational())))
}

/// The proof that p is inside, from the coefficients of all generators but the two of the facet: the two and a third
/// make up for what is left, or, where the two are too short for that, three long ones.
fn member(query: &Query<'_, 3>, p: &Pairs, pair: [usize; 2], u: &[f64; 3], mut coefficients: Vec<f64>) -> Option<Told> {
    let generator = |i: usize| query.generator(i);
    let off_facet = (0..query.len()).filter(|i| !pair.contains(i));
    let facet = [pair[0], pair[1], farthest_from_plane(u, off_facet, generator)?];
    let (triple, rest) = left_for(query, p, facet, &mut coefficients);
    triple.determinant.sign()?;
    if let Some(own) = triple.absorb(&rest) {
        return Some(told(facet, own, coefficients));
    }
    for (i, numerator) in facet.into_iter().zip(triple.numerators(&rest)) {
        let likely = (numerator.high / triple.determinant.high).clamp(-1.0, 1.0);
        // of a generator too short to make up for anything nothing is known
        coefficients[i] = if likely.is_nan() { 0.0 } else { likely };
    }
    let basis = well_spread(0..query.len(), generator)?;
    let (triple, rest) = left_for(query, p, basis, &mut coefficients);
    Some(told(basis, triple.absorb(&rest)?, coefficients))
}

fn told(basis: [usize; 3], own: [f64; 3], mut coefficients: Vec<f64>) -> Told {
    for (coefficient, i) in own.into_iter().zip(basis) {
        coefficients[i] = coefficient;
    }
    Told::combined(coefficients, basis)
}

/// Three generators, and what all others leave of p for them; sets the coefficients of the three to zero.
fn left_for(
    query: &Query<'_, 3>,
    p: &Pairs,
    basis: [usize; 3],
    coefficients: &mut [f64],
) -> (Triple<BoundedDoubleDouble>, Pairs) {
    basis.iter().for_each(|&i| coefficients[i] = 0.0);
    let off = combined(query, coefficients);
    let vectors = basis.map(|i| query.generator(i).map(BoundedDoubleDouble::exact));
    (Triple::new(&vectors), [p[0] - off[0], p[1] - off[1], p[2] - off[2]])
}

/// Σ c v.
fn combined(query: &Query<'_, 3>, coefficients: &[f64]) -> Pairs {
    let [first, second] = query.rows().map(Rows::list);
    let (own, others) = coefficients.split_at(first.len());
    let (own, others) = (combined_sum(first, own), combined_sum(second, others));
    [own[0] + others[0], own[1] + others[1], own[2] + others[2]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::collision::proof::of_optimum::of_told;
    use crate::interop::verifier::check_location;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn points_near_a_facet_of_nearly_parallel_or_uneven_generators_are_proved() {
        let random = &mut Pcg64Mcg::seed_from_u64(6);
        for factor in [1.0 - 1e-12, 1.0 + 1e-12] {
            for is_uneven in [false, true] {
                let proved = (0..60).filter(|_| is_proved(random, is_uneven, factor)).count();
                assert!(proved >= 55, "{factor} {is_uneven}: {proved}");
            }
        }
    }

    /// Whether the facet of some pair proves where a point near the boundary of a body lies: one of two nearly parallel
    /// generators and three others, or of five of very different lengths.
    fn is_proved(random: &mut Pcg64Mcg, is_uneven: bool, factor: f64) -> bool {
        let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
        let a = vector(1.0);
        let (tiny, direction) = (vector(1e-9), vector(1.0));
        let b = [0, 1, 2].map(|k| a[k] + tiny[k]);
        let body = if is_uneven {
            [vector(1e40), vector(1e-9), vector(1e25), vector(1e7), vector(1e-30)]
        } else {
            [a, b, vector(1.0), vector(1.0), vector(1.0)]
        };
        let gauge = brute_force::gauge(&Query::new([0.0; 3], direction, &body).expect("finite")).value;
        let p = direction.map(|c| c * (factor / gauge));
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let pairs = (0..5).flat_map(|i| (0..i).map(move |j| [i, j]));
        let locations = pairs.filter_map(|[i, j]| {
            let u = cross(&body[i], &body[j]);
            let sign = f64::copysign(1.0, dot(&u, &p));
            let u = u.map(|c| sign * c);
            let shares = body.map(|v| f64::copysign(1.0, dot(&v, &u)));
            location_in_pairs(&query, [i, j], &u, sign < 0.0, &shares).map(|told| of_told(told, &mut ()))
        });
        let checked = locations.map(|location| {
            assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
            assert_eq!(location.is_member(), factor < 1.0);
        });
        checked.count() > 0
    }
}
