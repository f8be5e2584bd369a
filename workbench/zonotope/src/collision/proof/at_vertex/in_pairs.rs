//! The proof of a location by the facet that two generators span, where doubles leave a doubt of it.
//!
//! Of the normal of two generators that are nearly parallel, or of very different lengths, doubles know few digits, and
//! near the boundary so they do of the coefficients. Pairs of doubles know twice as many of both: of the signs that are
//! in doubt, of the sum of all generators but the two, whose products with the normal are zero and not what rounding
//! makes of them, and of what the basis makes up for.

use crate::collision::answer::Proof;
use crate::collision::proof::balance::choice::{farthest_from_plane, well_spread};
use crate::collision::proof::balance::triple::Triple;
use crate::collision::proof::direction_of_doubles::{Beyond, Pairs};
use crate::collision::proof::of_optimum::separation::exact_rung;
use crate::collision::proof::vectors::Vectors;
use crate::lad::of_generators::seam::generators::KernelQuery;
use crate::numeric::bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear;
use crate::numeric::linear::{cross, dot};
use crate::tally::Rung;
use crate::zonotope::location::{Location, Separation, Witness};

/// Where p lies, with its proof, from the computed normal u of two generators, which is a × b or, if it is reversed,
/// its opposite, and the signs of the products of all others with u, or shares in [−1, 1]. O(n).
pub(super) fn location_in_pairs(
    query: &dyn KernelQuery,
    vectors: &Vectors<'_>,
    pair: [usize; 2],
    u: &[f64; 3],
    is_reversed: bool,
    shares: &[f64],
) -> Option<Proof> {
    let p = query.displacement_pairs();
    let spanning = pair.map(|i| vectors.pairs(i));
    let computed = cross(&spanning[0], &spanning[1]);
    let normal = if is_reversed { computed.map(BoundedDoubleDouble::negated) } else { computed };
    let rounded_normal = bounded::cross(&vectors.bounded(pair[0]), &vectors.bounded(pair[1]));
    let mut coefficients = shares.to_vec();
    // at most by so much is Σ |v · n| larger than n · S, as some signs are not certain
    let mut doubt = BoundedDoubleDouble::exact(0.0);
    for (i, v) in vectors.iter().enumerate() {
        let is_certain = dot(&v, &rounded_normal).sign().is_some();
        if pair.contains(&i) {
            coefficients[i] = 0.0;
        } else if !is_certain || shares[i].abs() < 1.0 {
            let product = dot(&normal, &vectors.pairs(i));
            match product.sign() {
                Some(sign) if shares[i].abs() == 1.0 => coefficients[i] = f64::from(sign),
                _ => doubt = doubt + product.largest(),
            }
        }
    }
    let sum = query.combined(&coefficients);
    let (along, reach) = (dot(&normal, &p), dot(&normal, &sum));
    if (along - reach - doubt - doubt).sign() == Some(1) {
        let beyond = Beyond { normal, rest: [p[0] - sum[0], p[1] - sum[1], p[2] - sum[2]], spanning };
        let separation = separation(query, &beyond, pair, is_reversed);
        return Some(Proof { rung: exact_rung(&separation), location: Location::Outside(separation) });
    }
    let factor = (along / reach).high;
    coefficients.iter_mut().for_each(|coefficient| *coefficient *= factor);
    // false for NaN as well
    let is_member = factor < 1.0;
    if is_member { member(query, vectors, &p, pair, u, coefficients) } else { None }
}

/// The direction of the facet, which separates: in doubles, if that is found to separate as well.
fn separation(query: &dyn KernelQuery, beyond: &Beyond, pair: [usize; 2], is_reversed: bool) -> Separation<3> {
    if let Some(direction) = beyond.direction_of_doubles(query) {
        return Separation::Rounded(direction);
    }
    let [a, b] = pair.map(|i| query.exact_generator(i));
    let normal = if is_reversed { exact_linear::cross(&b, &a) } else { exact_linear::cross(&a, &b) };
    Separation::Exact(Box::new(normal.map(|c| c.to_rational())))
}

/// The proof that p is inside, from the coefficients of all generators but the two of the facet: the two and a third
/// make up for what is left, or, where the two are too short for that, three long ones.
fn member(
    query: &dyn KernelQuery,
    vectors: &Vectors<'_>,
    p: &Pairs,
    pair: [usize; 2],
    u: &[f64; 3],
    mut coefficients: Vec<f64>,
) -> Option<Proof> {
    let off_facet = (0..vectors.len()).filter(|i| !pair.contains(i));
    let facet = [pair[0], pair[1], farthest_from_plane(u, off_facet, |i| vectors.value(i))?];
    let (triple, rest) = left_for(query, vectors, p, facet, &mut coefficients);
    triple.determinant.sign()?;
    if let Some(own) = triple.absorb(&rest) {
        return Some(proof(facet, own, coefficients));
    }
    for (i, numerator) in facet.into_iter().zip(triple.numerators(&rest)) {
        let likely = (numerator.high / triple.determinant.high).clamp(-1.0, 1.0);
        // of a generator too short to make up for anything nothing is known
        coefficients[i] = if likely.is_nan() { 0.0 } else { likely };
    }
    let basis = well_spread(0..vectors.len(), |i| vectors.value(i))?;
    let (triple, rest) = left_for(query, vectors, p, basis, &mut coefficients);
    Some(proof(basis, triple.absorb(&rest)?, coefficients))
}

fn proof(basis: [usize; 3], own: [f64; 3], mut coefficients: Vec<f64>) -> Proof {
    for (coefficient, i) in own.into_iter().zip(basis) {
        coefficients[i] = coefficient;
    }
    Proof::inside(Witness::in_order(coefficients, basis), Rung::RoundedCoefficients)
}

/// Three generators, and what all others leave of p for them; sets the coefficients of the three to zero.
fn left_for(
    query: &dyn KernelQuery,
    vectors: &Vectors<'_>,
    p: &Pairs,
    basis: [usize; 3],
    coefficients: &mut [f64],
) -> (Triple<BoundedDoubleDouble>, Pairs) {
    basis.iter().for_each(|&i| coefficients[i] = 0.0);
    let off = query.combined(coefficients);
    (Triple::new(&basis.map(|i| vectors.pairs(i))), [p[0] - off[0], p[1] - off[1], p[2] - off[2]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::interop::verifier::check_location;
    use crate::zonotope::query::Query;
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
            let vectors = Vectors::of(&query).expect("it has no matrix");
            location_in_pairs(&query, &vectors, [i, j], &u, sign < 0.0, &shares).map(|proof| proof.location)
        });
        let checked = locations.map(|location| {
            assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
            assert_eq!(location.is_member(), factor < 1.0);
        });
        checked.count() > 0
    }
}
