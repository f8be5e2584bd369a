//! The proof of a member in doubles, from a vertex that doubles proved.
//!
//! All generators have ±c, c near 1 / λ, but for three that balance the rest: the two of the vertex and a third, off
//! the facet's plane. Where the point is at an edge of its facet, the coefficients of the two are at the ends of
//! their range. Then the third generator is one that moves both inwards as its own coefficient leaves its end, which
//! it may do as far as c can grow towards 1.

use crate::collision::Witness;
use crate::collision::proof::balance::well_spread::well_spread;
use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::{Bounded, BoundedVector, approximate, cross};
use crate::numeric::linear::{cyclic_cross_products, dot};
use crate::numeric::tolerance::UNIT;
use crate::tally::Rung;

/// The number of generators that are tried as the third.
const THIRD_CANDIDATES: usize = 32;

/// A margin of this part of 1 − 1 / λ is good enough to stop looking for a better third generator.
const MARGIN_SHARE: f64 = 0.25;

/// The part of its range by which the third generator moves away from its end.
const THIRD_ROOM: f64 = 0.5;

/// A generator that may be the third, with what its coefficient is computed from.
#[derive(Debug, Clone, Copy)]
struct Third {
    index: usize,
    vector: [f64; 3],
    sign: f64,
    /// The cross products of the three generators, in which coefficients are read off.
    normals: [[f64; 3]; 3],
    /// 1 over the determinant of the three; infinite where the third is in the plane of the others.
    inverse: f64,
}

/// Three generators and the factor of all others.
#[derive(Debug, Clone, Copy)]
struct Attempt {
    third: usize,
    sign: f64,
    factor: f64,
    /// The distance of the largest of the three coefficients from 1, nearly.
    margin: f64,
}

impl Third {
    fn new(optimum: &RoundedOptimum, index: usize, vector: [f64; 3], sign: f64) -> Self {
        let [a, b] = &optimum.vectors;
        let normals = cyclic_cross_products(a, b, &vector);
        Self { index, vector, sign, normals, inverse: 1.0 / dot(&vector, &normals[2]) }
    }

    /// The attempt with a factor, and its margin.
    fn attempt(&self, optimum: &RoundedOptimum, p: &BoundedVector, factor: f64) -> Attempt {
        let rest = |k: usize| p[k].value - (optimum.sum[k].value - self.sign * self.vector[k]) * factor;
        let rest = [rest(0), rest(1), rest(2)];
        let size = |k: usize| (dot(&rest, &self.normals[k]) * self.inverse).abs();
        let largest = size(0).max(size(1)).max(size(2));
        // none where the third is in the plane of the others
        let margin = if self.inverse.is_finite() { 1.0 - largest } else { 0.0 };
        Attempt { third: self.index, sign: self.sign, factor, margin }
    }
}

/// The proof of a member whose gauge is less than 1.
pub(crate) fn witness(
    query: &dyn KernelQuery,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    p: &BoundedVector,
) -> Option<(Witness, Rung)> {
    let inverse = (optimum.along.value / optimum.reach.value).min(1.0);
    let n = query.len();
    let last = optimum.cell();
    let is_shared = |i: &usize| optimum.shares.binary_search_by_key(i, |(index, _)| *index).is_ok();
    let picks =
        (0..n).step_by(n.div_ceil(THIRD_CANDIDATES).max(1)).filter(|i| !optimum.basis.contains(i) && !is_shared(i));
    // far enough from the ends: no other pick is much better, unless rounding forbids this one
    let mut enough = MARGIN_SHARE * (1.0 - inverse);
    let mut best = Attempt { third: 0, sign: 0.0, factor: 0.0, margin: 0.0 };
    for index in picks {
        let third = Third::new(optimum, index, query.generator(index), cells.sign(query, &last, index));
        let height = third.sign * dot(&third.vector, &optimum.direction.map(|c| c.value)) / optimum.reach.value;
        let moved = (inverse * (1.0 + THIRD_ROOM * height)).min(1.0);
        for factor in [moved, inverse, 1.0] {
            let own = third.attempt(optimum, p, factor);
            if own.margin > best.margin {
                best = own;
            }
        }
        if best.margin > enough && enough > 0.0 {
            if let Some(found) = prove(query, optimum, cells, p, best) {
                return Some((found, Rung::RoundedCoefficients));
            }
            enough = 0.0;
        }
    }
    let proved = if best.margin > 0.0 { prove(query, optimum, cells, p, best) } else { None };
    match proved {
        Some(witness) => Some((witness, Rung::RoundedCoefficients)),
        None => Some((prove_by_others(query, optimum, cells, p, inverse)?, Rung::WellSpreadBasis)),
    }
}

/// The proof by an attempt, if rounding leaves no doubt of it.
fn prove(
    query: &dyn KernelQuery,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    p: &BoundedVector,
    attempt: Attempt,
) -> Option<Witness> {
    let Attempt { third, sign, factor, .. } = attempt;
    let [a, b] = optimum.bounded_vectors();
    let c = approximate(query.generator(third), query.relative_error());
    // the coefficients of those that share are rounded
    let rounded = Bounded { value: 0.0, error: 2.0 * (UNIT * optimum.shared + f64::MIN_POSITIVE) };
    let (sign, share) = (Bounded::exact(sign), Bounded::exact(factor));
    let rest = |k: usize| p[k] - (optimum.sum[k] - c[k] * sign) * share + rounded;
    let own = solve(&[a, b, c], &[rest(0), rest(1), rest(2)])?;
    let mut coefficients = cells.coefficients(query, &optimum.cell(), factor);
    for &(index, share) in &optimum.shares {
        coefficients[index] = share * factor;
    }
    Some(Witness::with_basis(coefficients, [optimum.basis[0], optimum.basis[1], third], own))
}

/// The proof where the two of the vertex are nearly parallel: three others, well spread, make up for the rest.
fn prove_by_others(
    query: &dyn KernelQuery,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    p: &BoundedVector,
    factor: f64,
) -> Option<Witness> {
    let basis = well_spread(query.len(), |i| query.generator(i))?;
    let is_other = |i: &usize| !optimum.basis.contains(i) && optimum.shares.iter().all(|(index, _)| index != i);
    basis.iter().all(is_other).then_some(())?;
    let signs = basis.map(|i| cells.sign(query, &optimum.cell(), i));
    let vectors = basis.map(|i| approximate(query.generator(i), query.relative_error()));
    let pair = optimum.bounded_vectors();
    let parts = optimum.rest.coefficients;
    // the coefficients of those that share, and of the two of the vertex, are rounded
    let size = optimum.shared + optimum.vectors.as_flattened().iter().map(|c| c.abs()).sum::<f64>();
    let rounded = Bounded { value: 0.0, error: 2.0 * (UNIT * size + f64::MIN_POSITIVE) };
    let rest = [0, 1, 2].map(|k| {
        let ends = pair[0][k] * Bounded::exact(parts[0]) + pair[1][k] * Bounded::exact(parts[1]);
        let own = (0..3).map(|i| vectors[i][k] * Bounded::exact(-signs[i]));
        let off = own.fold(optimum.sum[k] + ends, |sum, term| sum + term);
        p[k] - off * Bounded::exact(factor) + rounded
    });
    let own = solve(&vectors, &rest)?;
    let mut coefficients = cells.coefficients(query, &optimum.cell(), factor);
    let shares = optimum.shares.iter().copied().chain(optimum.basis.into_iter().zip(parts));
    for (index, share) in shares {
        coefficients[index] = share * factor;
    }
    Some(Witness::with_basis(coefficients, basis, own))
}

/// The coefficients of three vectors that make up what is left, if all are certainly within (−1, 1).
fn solve([a, b, c]: &[BoundedVector; 3], rest: &BoundedVector) -> Option<[f64; 3]> {
    let normals = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(c, &normals[2]);
    let negative = determinant.sign()? < 0;
    let determinant = if negative { determinant.negated() } else { determinant };
    // three of each written out: the question about a box is half as long as a call for each of them
    let [first, second, third] = [dot(rest, &normals[0]), dot(rest, &normals[1]), dot(rest, &normals[2])];
    let is_within = first.is_within(determinant) && second.is_within(determinant) && third.is_within(determinant);
    let scale = if negative { -determinant.value } else { determinant.value };
    is_within.then_some([first.value / scale, second.value / scale, third.value / scale])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Location;
    use crate::interop::verifier::check_location;
    use crate::lad::of_generators::cells::reduced::Reduced;
    use crate::numeric::bounded;
    use crate::numeric::linear::cross;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The proof from the vertex of the first two generators, checked exactly.
    fn prove(generators: &[[f64; 3]], p: [f64; 3]) -> Option<Witness> {
        let query = Query::new([0.0; 3], p, generators).expect("finite");
        let p = crate::numeric::bounded::exact(p);
        let optimum = RoundedOptimum::at(&[Reduced::whole(&query)], &p, [0, 1]).ok()?;
        let (witness, _) = witness(&query, &optimum, &NestedCells::default(), &p)?;
        assert!(check_location(&query, &Location::Inside(witness.clone())).is_right());
        Some(witness)
    }

    const BODY: [[f64; 3]; 6] =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.1, 1.0], [0.3, 0.0, 1.0], [0.1, -0.2, 1.0], [-0.2, 0.1, 0.7]];

    #[test]
    fn points_below_a_facet_are_proved() {
        let top = BODY[2..].iter().fold([0.0; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + v[k]));
        for (x, y) in [(0.0, 0.0), (0.5, -0.25), (0.999, 0.0), (1.0, 1.0), (-1.0, 0.3)] {
            for factor in [0.5, 0.9, 1.0 - 1e-9] {
                let p = [top[0] + x, top[1] + y, top[2]].map(|c| c * factor);
                let witness = prove(&BODY, p).unwrap_or_else(|| panic!("{x} {y} {factor}"));
                assert!(witness.basis.len() == 3 && witness.basis[..2] == [0, 1], "{witness:?}");
            }
        }
    }

    #[test]
    fn shares_of_a_facet_are_part_of_the_proof() {
        let body: Vec<[f64; 3]> =
            BODY.into_iter().chain([[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.3, 0.0, 0.0]]).collect();
        let top = BODY[2..].iter().fold([0.0; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + v[k]));
        for (x, y) in [(0.0, 0.0), (2.5, 0.7), (-3.2, 0.1), (0.0, 2.9)] {
            let p = [top[0] + x, top[1] + y, top[2]].map(|c| c * 0.99);
            let witness = prove(&body, p).unwrap_or_else(|| panic!("{x} {y}"));
            assert!(witness.basis.iter().all(|index| *index < 6), "{witness:?}");
        }
    }

    #[test]
    fn where_the_two_of_the_vertex_are_nearly_parallel_others_make_up_for_them() {
        let a = [1.0, 0.3, 0.1];
        let b = [a[0] + 0.2e-9, a[1] - 0.7e-9, a[2] + 0.4e-9];
        let normal = cross(&a, &b);
        let others = [[0.3, 0.6, 2.7], [0.0, 3.0, 0.3], [1.2, -0.9, 1.5], [-0.6, 1.8, 0.9]];
        let body: Vec<[f64; 3]> = [a, b].into_iter().chain(others).collect();
        let top = others.iter().fold([0.0; 3], |sum, v| {
            let sign = f64::copysign(1.0, dot(v, &normal));
            [0, 1, 2].map(|k| sum[k] + sign * v[k])
        });
        for factor in [0.5, 0.9, 1.0 - 1e-9] {
            let p = [0, 1, 2].map(|k| factor * (top[k] + 0.3 * a[k] - 0.2 * b[k]));
            let witness = prove(&body, p).unwrap_or_else(|| panic!("{factor}"));
            assert!(witness.basis.len() == 3, "{witness:?}");
        }
    }

    #[test]
    fn points_outside_are_not() {
        assert!(prove(&BODY, [0.2, 0.0, 4.0]).is_none());
    }

    /// The optimum at the vertex of the first two generators, with the query.
    fn optimum_at(query: &Query<'_, 3>, p: [f64; 3]) -> Option<crate::numeric::reused::ReusedBox<RoundedOptimum>> {
        RoundedOptimum::at(&[Reduced::whole(query)], &bounded::exact(p), [0, 1]).ok()
    }

    /// A body and a point below the facet of its first two, in whose plane there may be others.
    fn below(random: &mut Pcg64Mcg, scale: f64, members: usize, factor: f64) -> (Vec<[f64; 3]>, [f64; 3]) {
        let mut vector = || [0, 1, 2].map(|_| scale * random.random_range(-1.0..1.0f64));
        let (a, b) = (vector(), vector());
        let others: Vec<[f64; 3]> = (0..4).map(|_| vector()).collect();
        let in_plane = [[1.0, 0.5], [-0.5, 1.0], [0.75, -0.25]];
        let of = |[s, t]: [f64; 2]| [0, 1, 2].map(|k| s * a[k] + t * b[k]);
        let normal = cross(&a, &b);
        let mut p = of([0.3 + 0.4 * members as f64, -0.2]);
        for v in &others {
            let sign = f64::copysign(1.0, dot(v, &normal));
            p = [0, 1, 2].map(|k| p[k] + sign * v[k]);
        }
        let shared = in_plane[..members].iter().map(|parts| of(*parts));
        ([a, b].into_iter().chain(others).chain(shared).collect(), p.map(|c| factor * c))
    }

    /// The coefficients of three vectors that make up a rest.
    fn solved(basis: [&[f64; 3]; 3], rest: &[f64; 3]) -> [f64; 3] {
        let normals = cyclic_cross_products(basis[0], basis[1], basis[2]);
        let determinant = dot(basis[0], &normals[0]);
        normals.map(|normal| dot(rest, &normal) / determinant)
    }

    fn is_right(query: &Query<'_, 3>, witness: &Witness) -> bool {
        let exact = witness.clone().with_nearest_basis(query);
        let is_near = |(exact, own): (&f64, &f64)| (exact - own).abs() < 1e-6;
        exact.coefficients.iter().zip(&witness.coefficients).all(is_near)
            && check_location(query, &Location::Inside(exact)).is_right()
    }

    #[test]
    fn an_attempt_has_the_margin_of_its_coefficients_and_is_proved_where_there_is_one() {
        let random = &mut Pcg64Mcg::seed_from_u64(141);
        let (mut proved, mut refused) = (0, 0);
        for round in 0..300 {
            let (scale, members) = ([1.0, 1e-5, 1e5][round % 3], round / 3 % 3);
            let inverse = [0.5, 0.9, 0.99][round / 9 % 3];
            let (body, p) = below(random, scale, members, inverse);
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let Some(optimum) = optimum_at(&query, p) else { continue };
            let bounded = bounded::exact(p);
            for index in 2..6 {
                let cells = NestedCells::default();
                let sign = cells.sign(&query, &optimum.cell(), index);
                let third = Third::new(&optimum, index, body[index], sign);
                for factor in [inverse, 0.5 * (1.0 + inverse), 1.0] {
                    let attempt = third.attempt(&optimum, &bounded, factor);
                    let sum = optimum.sum.map(|c| c.value);
                    let rest = [0, 1, 2].map(|k| p[k] - factor * (sum[k] - sign * body[index][k]));
                    let own = solved([&body[0], &body[1], &body[index]], &rest);
                    let margin = 1.0 - own.iter().fold(0.0f64, |most, c| most.max(c.abs()));
                    assert!((attempt.margin - margin).abs() < 1e-6 * (1.0 + margin.abs()), "{attempt:?} {margin}");
                    assert_eq!((attempt.third, attempt.sign, attempt.factor), (index, sign, factor));
                    let found = super::prove(&query, &optimum, &cells, &bounded, attempt);
                    if let Some(witness) = &found {
                        assert!(is_right(&query, witness), "{body:?} {p:?} {attempt:?}");
                        for (i, c) in [0, 1, index].into_iter().zip(own) {
                            assert!((witness.coefficients[i] - c).abs() < 1e-6, "{witness:?} {own:?}");
                        }
                    }
                    (proved, refused) = (proved + u32::from(found.is_some()), refused + u32::from(found.is_none()));
                    assert!(margin.abs() < 1e-6 || found.is_some() == (margin > 0.0), "{margin} {found:?}");
                }
            }
        }
        assert!(proved > 300 && refused > 300, "{proved} {refused}");
    }

    #[test]
    fn a_generator_in_the_plane_of_the_two_is_no_third_one() {
        let body = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.0, 1.0], [1.0, 1.0, 0.0]];
        let p = [0.25, 0.0, 0.5];
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let optimum = optimum_at(&query, p).expect("below the facet");
        let third = Third::new(&optimum, 3, body[3], 1.0);
        assert_eq!(third.attempt(&optimum, &bounded::exact(p), 0.5).margin, 0.0);
    }

    /// The two of the vertex are nearly parallel, and there may be one more in their plane.
    #[test]
    fn three_others_make_up_for_what_two_nearly_parallel_ones_leave() {
        let random = &mut Pcg64Mcg::seed_from_u64(142);
        let mut found = [0, 0, 0];
        for round in 0..300 {
            let scale = [1.0, 1e-5, 1e5][round % 3];
            let size = [0.25, 0.25, 4.0][round / 3 % 3];
            let mut vector = |size: f64| [0, 1, 2].map(|_| scale * size * random.random_range(-1.0..1.0f64));
            let (a, small) = (vector(size), vector(1e-9));
            let b = [0, 1, 2].map(|k| a[k] + small[k]);
            let others = [vector(1.0), vector(1.0), vector(1.0), vector(1.0)];
            let mut body = [&[a, b][..], &others[..]].concat();
            let is_shared = round / 3 % 3 == 1;
            if is_shared {
                body.push([0, 1, 2].map(|k| 0.5 * a[k] - 0.25 * b[k]));
            }
            let normal = cross(&a, &small);
            let inverse = [0.5, 0.8][round % 2];
            let p = [0, 1, 2].map(|k| {
                let top = others.iter().map(|v| f64::copysign(1.0, dot(v, &normal)) * v[k]).sum::<f64>();
                inverse * (top + 0.3 * a[k] - 0.2 * b[k])
            });
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let Some(optimum) = optimum_at(&query, p) else { continue };
            let bounded = bounded::exact(p);
            for factor in [inverse, 0.9] {
                let own = prove_by_others(&query, &optimum, &NestedCells::default(), &bounded, factor);
                if let Some(witness) = own {
                    assert!(is_right(&query, &witness), "{body:?} {p:?} {factor} {witness:?}");
                    assert!(witness.basis.iter().all(|i| (2..6).contains(i)), "{witness:?}");
                    found[round / 3 % 3] += 1;
                }
            }
        }
        assert!(found[0] > 60 && found[1] > 60, "{found:?}");
    }

    #[test]
    fn three_vectors_make_up_a_rest_if_all_coefficients_are_within_their_ends() {
        for scale in [1.0, 1e-6, 1e6] {
            for (a, b) in [(0, 1), (1, 0)] {
                let mut rows = [[1.0, 0.25, 0.0], [0.0, 2.0, 0.5], [0.25, 0.0, 4.0]].map(|v| v.map(|c| scale * c));
                rows.swap(a, b);
                for parts in [[0.5, -0.25, 0.75], [-0.875, 0.999, -0.5]] {
                    let of = |parts: [f64; 3]| {
                        bounded::exact([0, 1, 2].map(|k| (0..3).map(|i| parts[i] * rows[i][k]).sum::<f64>()))
                    };
                    let vectors = rows.map(bounded::exact);
                    let own = solve(&vectors, &of(parts)).expect("all are within");
                    assert!((0..3).all(|k| (own[k] - parts[k]).abs() < 1e-12), "{own:?} {parts:?}");
                    for k in 0..3 {
                        for end in [1.0, -1.0, 1.5, -2.0] {
                            let mut beyond = parts;
                            beyond[k] = end;
                            assert_eq!(solve(&vectors, &of(beyond)), None, "{beyond:?}");
                        }
                    }
                    let dependent = [vectors[0], vectors[1], vectors[0]];
                    assert_eq!(solve(&dependent, &of(parts)), None);
                }
            }
        }
    }
}
