//! The coefficients of a basis that make up for what other coefficients leave, exactly: the step that ends a search for
//! a witness.

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear;
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::zonotope::location::Witness;
use crate::zonotope::query::Query;

/// The displacement minus the generators off the basis, each with its coefficient. O(n) exact additions.
pub(in crate::collision) fn left_over<const D: usize>(
    query: &Query<'_, D>,
    displacement: &[Dyadic; D],
    coefficients: &[f64],
    basis: &[usize],
) -> [Dyadic; D] {
    let mut whole: [ExactSum; D] = std::array::from_fn(|_| ExactSum::default());
    let mut left = displacement.clone();
    for ((i, g), &c) in query.generators().enumerate().zip(coefficients) {
        if c == 0.0 || basis.contains(&i) {
            continue;
        }
        for (axis, &v) in g.iter().enumerate() {
            if c.abs() == 1.0 {
                whole[axis].add(-c * v);
            } else if v != 0.0 {
                left[axis] = &left[axis] - &(&Dyadic::from_f64(c) * &Dyadic::from_f64(v));
            }
        }
    }
    std::array::from_fn(|axis| &left[axis] + &whole[axis].value())
}

/// The coefficients with Σ δ_b g_b = `sum` over the basis; `None` if its generators are dependent or nothing solves the
/// equation.
pub(in crate::collision) fn solve<const D: usize>(
    query: &Query<'_, D>,
    basis: &[usize],
    sum: &[Dyadic; D],
) -> Option<Vec<Rational>> {
    let columns: Vec<Vec<Rational>> =
        basis.iter().map(|&b| query.generator(b).map(exact_linear::rational).to_vec()).collect();
    exact_linear::solve(&columns, &sum.each_ref().map(Dyadic::to_rational))
}

/// The witness with nearly these coefficients of [−1, 1] and a basis with much room, and whether it proves an inner
/// point: D coefficients of the basis strictly between −1 and 1. `None` if the basis leaves [−1, 1].
pub(in crate::collision) fn near_witness<const D: usize>(
    query: &Query<'_, D>,
    displacement: &[Dyadic; D],
    mut coefficients: Vec<f64>,
) -> Option<(Witness, bool)> {
    let basis = roomy_basis(query, &coefficients);
    let values = solve(query, &basis, &left_over(query, displacement, &coefficients, &basis))?;
    let mut is_strict = true;
    for (&b, value) in basis.iter().zip(&values) {
        if *value > Rational::ONE || *value < Rational::NEG_ONE {
            return None;
        }
        is_strict &= *value < Rational::ONE && *value > Rational::NEG_ONE;
        coefficients[b] = value.to_f64().value();
    }
    let is_inside = is_strict && basis.len() == D;
    Some((Witness { coefficients, basis }, is_inside))
}

/// Generators, independent in floating point, chosen in turn for the room that their coefficients have times how far
/// they lead out of the span of those before; in increasing order.
fn roomy_basis<const D: usize>(query: &Query<'_, D>, coefficients: &[f64]) -> Vec<usize> {
    let mut scales = [0i64; D];
    for (axis, scale) in scales.iter_mut().enumerate() {
        *scale = query.generators().filter_map(|g| binary_exponent(g[axis])).max().map_or(0, i64::from);
    }
    let mut left: Vec<[f64; D]> =
        query.generators().map(|g| std::array::from_fn(|axis| scale_by_power_of_two(g[axis], -scales[axis]))).collect();
    let mut basis = Vec::new();
    while basis.len() < D {
        let length = |v: &[f64; D]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let room = |i: usize| (1.0 - coefficients[i].abs()) * length(&left[i]);
        let best = (0..left.len()).max_by(|&i, &j| room(i).total_cmp(&room(j)));
        // Below this, a residual is what rounding left of a member of the span.
        let Some(best) = best.filter(|&i| room(i) > 0.0 && length(&left[i]) > 1e-13) else { break };
        basis.push(best);
        let size = length(&left[best]);
        let axis = left[best].map(|v| v / size);
        for vector in &mut left {
            let along: f64 = vector.iter().zip(&axis).map(|(a, b)| a * b).sum();
            vector.iter_mut().zip(&axis).for_each(|(a, b)| *a -= along * b);
        }
        left[best] = [0.0; D];
    }
    basis.sort_unstable();
    basis
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    const CUBE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    fn exact(v: [f64; 3]) -> [Dyadic; 3] {
        v.map(Dyadic::from_f64)
    }

    fn query(rows: &[[f64; 3]]) -> Query<'_, 3> {
        Query::new([0.0; 3], [0.0; 3], rows).expect("finite")
    }

    #[test]
    fn what_is_left_is_the_displacement_less_all_terms_off_the_basis() {
        let random = &mut Pcg64Mcg::seed_from_u64(91);
        for round in 0..100 {
            let n = 1 + round % 9;
            let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            let (rows, p): (Vec<[f64; 3]>, _) = ((0..n).map(|_| vector()).collect(), vector());
            let coefficients: Vec<f64> = (0..n).map(|i| [1.0, 0.0, -1.0, 0.3, -0.7, 1e-20][(i + round) % 6]).collect();
            let basis: Vec<usize> = (0..n).filter(|i| (i + round) % 4 == 0).collect();
            let own = left_over(&query(&rows), &exact(p), &coefficients, &basis);
            for k in 0..3 {
                let terms = (0..n).filter(|i| !basis.contains(i)).fold(Dyadic::zero(), |sum, i| {
                    sum + Dyadic::from_f64(coefficients[i]) * Dyadic::from_f64(rows[i][k])
                });
                assert_eq!(own[k], Dyadic::from_f64(p[k]) - terms, "{rows:?} {coefficients:?} {basis:?}");
            }
        }
    }

    #[test]
    fn coefficients_of_a_basis_solve_the_equation_or_there_are_none() {
        let rows = [[2.0, 0.0, 0.0], [1.0, 4.0, 0.0], [0.0, 0.0, 8.0], [4.0, 0.0, 0.0]];
        let own = solve(&query(&rows), &[0, 1, 2], &exact([3.0, 2.0, -1.0])).expect("the three are independent");
        assert_eq!(own.iter().map(|value| value.to_f64().value()).collect::<Vec<_>>(), [1.25, 0.5, -0.125]);
        assert_eq!(solve(&query(&rows), &[0, 3], &exact([1.0, 0.0, 0.0])), None);
        assert_eq!(solve(&query(&rows), &[0, 1], &exact([1.0, 0.0, 1.0])), None);
    }

    #[test]
    fn a_witness_is_strictly_inside_where_all_of_a_basis_of_space_are() {
        let at = |rows: &[[f64; 3]], p: [f64; 3], near: &[f64]| near_witness(&query(rows), &exact(p), near.to_vec());
        let near = [0.5, 0.25, 0.75];
        for (z, told) in [
            (0.9, Some(true)),
            (1.0, Some(false)),
            (1.25, None),
            (-0.9, Some(true)),
            (-1.0, Some(false)),
            (-1.25, None),
        ] {
            for turn in 0..3 {
                let p = [0, 1, 2].map(|k| [0.5, 0.25, z][(k + turn) % 3]);
                let found = at(&CUBE, p, &near);
                assert_eq!(found.as_ref().map(|(_, is_inside)| *is_inside), told, "{p:?}");
                if let Some((witness, _)) = found {
                    assert_eq!((witness.basis, witness.coefficients), (vec![0, 1, 2], p.to_vec()));
                }
            }
        }
        // a flat body has no inside
        let (witness, is_inside) = at(&CUBE[..2], [0.5, 0.25, 0.0], &near[..2]).expect("it is a member");
        assert_eq!((witness.basis, is_inside), (vec![0, 1], false));
        assert!(at(&CUBE[..2], [0.5, 0.25, 0.5], &near[..2]).is_none());
    }

    #[test]
    fn the_basis_has_room_and_leads_out_of_its_own_span() {
        let rows = [[4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.5, 0.5, 2.0], [3.9, 0.0, 0.1]];
        assert_eq!(roomy_basis(&query(&rows), &[0.0; 4]), [0, 1, 2]);
        assert_eq!(roomy_basis(&query(&rows), &[-0.5, 0.0, 0.0, 0.0]), [1, 2, 3]);
        assert_eq!(roomy_basis(&query(&rows), &[0.5, 0.0, 0.0, 0.0]), [1, 2, 3]);
        // a coefficient at its end has no room
        assert_eq!(roomy_basis(&query(&rows), &[0.0, 1.0, 0.0, 0.0]), [0, 2, 3]);
        assert_eq!(roomy_basis(&query(&CUBE), &[0.0, 1.0, -1.0]), [0]);
        // lengths count in terms of the longest coordinates
        let thin = rows.map(|[x, y, z]| [x, y * 2f64.powi(-40), z * 2f64.powi(60)]);
        assert_eq!(roomy_basis(&query(&thin), &[0.0; 4]), [0, 1, 2]);
        assert_eq!(roomy_basis(&query(&thin), &[0.5, 0.0, 0.0, 0.0]), [1, 2, 3]);
    }

    #[test]
    fn a_basis_of_a_plane_has_two_members() {
        let (a, b) = ([1.0, 2.0, 2.0], [2.0, 1.0, -2.0]);
        let of = |s: f64, t: f64| [0, 1, 2].map(|k| s * a[k] + t * b[k]);
        let rows = [a, b, of(1.0, 1.0), of(0.3, -0.7), of(5.0, 3.0), of(-2.0, 0.1)];
        for first in 0..5 {
            let basis = roomy_basis(&query(&rows[first..]), &vec![0.25; 6 - first]);
            assert_eq!(basis.len(), 2.min(6 - first), "{basis:?}");
        }
        assert_eq!(roomy_basis(&query(&[a, of(2.0, 0.0), [0.0; 3]]), &[0.0; 3]), [1]);
        assert!(roomy_basis(&query(&[[0.0; 3]]), &[0.0]).is_empty());
    }
}
