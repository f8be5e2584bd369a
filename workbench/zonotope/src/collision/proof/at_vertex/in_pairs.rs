//! The proof of a location by the facet that two generators span, where doubles leave a doubt of it.
//!
//! Of the normal of two generators that are nearly parallel, or of very different lengths, doubles know few digits, and
//! near the boundary so they do of the coefficients. Pairs of doubles know twice as many of both: of the signs that are
//! in doubt, of the sum of all generators but the two, whose products with the normal are zero and not what rounding
//! makes of them, and of what the basis makes up for.

use std::cmp::Ordering;

use crate::collision::proof::direction_of_doubles::{Beyond, Pairs};
use crate::collision::proof::separation::exact_rung;
use crate::collision::proof::vectors::{Vectors, cross_terms, first_of_largest};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear;
use crate::numeric::linear::{cross, cyclic_cross_products, dot, max_norm};
use crate::numeric::tolerance::PRODUCT_UNDERFLOW;
use crate::tally::Rung;
use crate::zonotope::location::{Location, Proof, Separation, Witness};

/// The location of p, with its proof, from the computed normal u of two generators, which is a × b or, if it is
/// reversed, its opposite, and a share in [−1, 1] of each other generator: the sign of its product with u, as a rule.
/// A share of 1 or −1 may be another one than the sign. O(n).
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
    let area = cross_terms(&vectors.vector(pair[0]), &vectors.vector(pair[1]));
    let mut coefficients = shares.to_vec();
    // the sum of |v · n| over the generators whose sign is not certain: Σ |v · n| − n · S is at most twice this
    let mut doubt = BoundedDoubleDouble::exact(0.0);
    for (i, v) in vectors.iter().enumerate() {
        let along = dot(&v.value, u);
        let is_certain = along.abs() > vectors.determinant_error * dot(&v.size, &area) + PRODUCT_UNDERFLOW;
        if pair.contains(&i) {
            coefficients[i] = 0.0;
        } else if !is_certain || shares[i] != along.signum() {
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
    // All shares stay in [−1, 1] by such a factor; where n · S is near 0 or below, it may be anything. False for NaN.
    let is_member = factor.abs() < 1.0;
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
    let third = largest(vectors, |i, v| if pair.contains(&i) { 0.0 } else { dot(v, u).abs() })?;
    let facet = [pair[0], pair[1], third];
    let own = solve(query, vectors, p, facet, &mut coefficients)?;
    if let [Some(first), Some(second), Some(last)] = own.certain {
        return Some(proof(facet, [first, second, last], coefficients));
    }
    for (i, coefficient) in facet.into_iter().zip(own.likely) {
        coefficients[i] = coefficient.clamp(-1.0, 1.0);
    }
    let first = largest(vectors, |_, v| max_norm(v))?;
    let a = vectors.value(first);
    let second = largest(vectors, |_, v| max_norm(&cross(&a, v)))?;
    let normal = cross(&a, &vectors.value(second));
    let basis = [first, second, largest(vectors, |_, v| dot(&normal, v).abs())?];
    let own = solve(query, vectors, p, basis, &mut coefficients)?;
    let [Some(first), Some(second), Some(last)] = own.certain else { return None };
    Some(proof(basis, [first, second, last], coefficients))
}

fn proof(basis: [usize; 3], own: [f64; 3], coefficients: Vec<f64>) -> Proof {
    Proof::inside(Witness::with_basis(coefficients, basis, own), Rung::RoundedCoefficients)
}

/// The generator of the largest value, if one is positive.
fn largest(vectors: &Vectors<'_>, value: impl Fn(usize, &[f64; 3]) -> f64) -> Option<usize> {
    first_of_largest((0..vectors.len()).map(|i| (value(i, &vectors.value(i)), i)))
}

/// The coefficients of three generators.
struct Solution {
    /// Those that are certainly within (−1, 1).
    certain: [Option<f64>; 3],
    likely: [f64; 3],
}

/// The coefficients with which three generators make up for what all others leave of p; sets their places to zero.
fn solve(
    query: &dyn KernelQuery,
    vectors: &Vectors<'_>,
    p: &Pairs,
    basis: [usize; 3],
    coefficients: &mut [f64],
) -> Option<Solution> {
    basis.iter().for_each(|&i| coefficients[i] = 0.0);
    let off = query.combined(coefficients);
    let rest = [p[0] - off[0], p[1] - off[1], p[2] - off[2]];
    let [a, b, c] = basis.map(|i| vectors.pairs(i));
    let normals = cyclic_cross_products(&a, &b, &c);
    let determinant = dot(&c, &normals[2]);
    determinant.sign()?;
    let mut solution = Solution { certain: [None; 3], likely: [0.0; 3] };
    for (k, normal) in normals.iter().enumerate() {
        let numerator = dot(&rest, normal);
        let coefficient = (numerator.high / determinant.high).clamp(-1.0, 1.0);
        let is_within = numerator.abs().certain_order(&determinant.abs()) == Some(Ordering::Less);
        solution.certain[k] = is_within.then_some(coefficient);
        // of a generator too short to make up for anything nothing is known
        solution.likely[k] = if coefficient.is_finite() { coefficient } else { 0.0 };
    }
    Some(solution)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::interop::verifier::check_location;
    use crate::zonotope::location::Coefficients;
    use crate::zonotope::location::Status;
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
            location_in_pairs(&query, &vectors, [i, j], &u, sign < 0.0, &shares)
                .map(|proof| proof.location.written(&query))
        });
        let checked = locations.map(|location| {
            assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
            assert_eq!(location.is_member(), factor < 1.0);
        });
        checked.count() > 0
    }

    /// The answer in pairs from a facet and shares, checked exactly.
    fn answer(body: &[[f64; 3]], p: [f64; 3], pair: [usize; 2], is_reversed: bool, shares: &[f64]) -> Option<Proof> {
        let query = Query::new([0.0; 3], p, body).expect("finite");
        let vectors = Vectors::of(&query).expect("it has no matrix");
        let product = cross(&body[pair[0]], &body[pair[1]]);
        let u = if is_reversed { product.map(|c| -c) } else { product };
        let proof = location_in_pairs(&query, &vectors, pair, &u, is_reversed, shares)?;
        let written = proof.location.clone().written(&query);
        assert_eq!(check_location(&query, &written).proof().map(drop), Ok(()), "{body:?} {p:?} {shares:?}");
        Some(proof)
    }

    fn status(body: &[[f64; 3]], p: [f64; 3], pair: [usize; 2], is_reversed: bool, shares: &[f64]) -> Option<Status> {
        answer(body, p, pair, is_reversed, shares).map(|proof| proof.location.status())
    }

    #[test]
    fn the_top_of_a_box_worked_out_by_hand() {
        for scale in [1.0, 1e-6, 1e6] {
            let body =
                [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0], [0.25, 0.5, 0.5]].map(|v| v.map(|c| scale * c));
            // wrong shares of −1 become the signs that they should be
            for shares in [[1.0; 4], [1.0, 1.0, 1.0, -1.0], [1.0, 1.0, -1.0, 1.0], [-1.0; 4]] {
                let at = |z: f64| [0.45 * scale, -0.5 * scale, z * scale];
                for (pair, is_reversed) in [([0, 1], false), ([1, 0], true)] {
                    let own = |z: f64| status(&body, at(z), pair, is_reversed, &shares);
                    for z in [0.75, 1.4, 1.5 - 1e-9, 1.5 - 1e-14] {
                        assert_eq!(own(z), Some(Status::Inside), "{scale} {z}");
                    }
                    for z in [1.5 + 1e-14, 1.5 + 1e-9, 2.0] {
                        assert_eq!(own(z), Some(Status::Outside), "{scale} {z}");
                    }
                    if scale == 1.0 {
                        assert_eq!(own(1.5), None);
                    }
                }
                let below = status(&body, at(-1.25), [0, 1], true, &shares.map(|share| -share));
                assert_eq!(below, Some(Status::Inside), "{scale}");
            }
        }
    }

    #[test]
    fn coefficients_of_the_basis_are_near_those_that_they_imply() {
        let body = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 4.0]];
        let proof = answer(&body, [0.25, 0.5, 3.0], [0, 1], false, &[1.0; 3]).expect("below the top");
        let Location::Inside(Coefficients::Written(witness)) = proof.location else { unreachable!("it is inside") };
        assert_eq!((witness.basis, witness.coefficients), (vec![0, 1, 2], vec![0.25, 0.25, 0.75]));
    }

    /// A share between −1 and 1 of a generator off the plane says little of the support value: twice the product is in
    /// doubt.
    #[test]
    fn shares_off_the_plane_leave_a_doubt() {
        let body = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(status(&body, [0.0, 0.0, 0.25], [0, 1], false, &[1.0, 1.0, 0.5]), Some(Status::Inside));
        for z in [0.75, 0.99, 1.2] {
            // the share gives the half of the height, which proves nothing
            assert_eq!(status(&body, [0.0, 0.0, z], [0, 1], false, &[1.0, 1.0, 0.5]), None, "{z}");
        }
        assert_eq!(status(&body, [0.0, 0.0, 2.75], [0, 1], false, &[1.0, 1.0, 0.5]), Some(Status::Outside));
    }

    /// A generator that doubles place on the wrong side of the facet's plane, and a point that is inside because of it.
    #[test]
    fn signs_that_rounding_turns_around_are_set_right() {
        let random = &mut Pcg64Mcg::seed_from_u64(8);
        let (mut turned, mut proved) = (0, 0);
        for _ in 0..4000 {
            let mut whole = |most: f64| [0, 1, 2].map(|_| 4.0 * (most * random.random_range(-1.0..1.0f64)).round());
            let (a, small, c) = (whole(2f64.powi(46)), whole(2f64.powi(26)), whole(2f64.powi(49)));
            let b = [0, 1, 2].map(|k| a[k] + small[k]);
            let mut near = [0, 1, 2].map(|k| a[k] + b[k]);
            near[random.random_range(0..3)] += 1.0;
            let product = cross(&a, &b);
            let is_reversed = dot(&product, &c) < 0.0;
            let u = if is_reversed { product.map(|c| -c) } else { product };
            let pairs = [a, b, near].map(|v| v.map(BoundedDoubleDouble::exact));
            let normal = cross(&pairs[0], &pairs[1]).map(|c| if is_reversed { c.negated() } else { c });
            let along = dot(&near, &u);
            if dot(&normal, &pairs[2]).sign().is_none_or(|sign| f64::from(sign) == along.signum()) {
                continue;
            }
            turned += 1;
            let own = status(&[a, b, near, c], c, [0, 1], is_reversed, &[1.0, 1.0, along.signum(), 1.0]);
            assert_ne!(own, Some(Status::Outside), "{a:?} {b:?} {near:?} {c:?}");
            // beside the generator that is near the plane
            let p = [0, 1, 2].map(|k| c[k] + 0.5 * (a[k] - b[k]));
            let own = status(&[a, b, near, c], p, [0, 1], is_reversed, &[1.0, 1.0, along.signum(), 1.0]);
            assert_ne!(own, Some(Status::Outside), "{a:?} {b:?} {near:?} {c:?}");
            proved += u32::from(own.is_some());
            if turned > 40 {
                break;
            }
        }
        assert!(turned > 10, "{turned} {proved}");
    }

    /// Doubles near a slanted normal separate where the gap is wide enough, whatever the order of the axes.
    #[test]
    fn directions_beyond_a_slanted_facet_are_doubles() {
        for turn in 0..3 {
            let turned = |v: [f64; 3]| [0, 1, 2].map(|k| v[(k + turn) % 3]);
            let body = [[1.0, -0.7, 0.1], [0.2, 0.9, -1.0], [0.5, 0.6, 0.7], [3.0, -1.9, 0.2]].map(turned);
            let u = cross(&body[0], &body[1]);
            let shares = body.map(|v| f64::copysign(1.0, dot(&v, &u)));
            for is_reversed in [false, true] {
                let side = if is_reversed { -1.0 } else { 1.0 };
                let own = shares.map(|share| side * share);
                let top = [0, 1, 2].map(|k| (2..4).map(|i| own[i] * body[i][k]).sum::<f64>());
                let p = top.map(|c| c * (1.0 + 1e-11));
                let proof = answer(&body, p, [0, 1], is_reversed, &own).expect("beyond the facet");
                assert_eq!(proof.rung, crate::tally::Rung::DirectionOfDoubles, "{turn} {is_reversed}");
            }
        }
    }
}
