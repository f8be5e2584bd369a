//! The generators whose sign at a vertex is not certain: those of its facet, or nearly, beside the two of the vertex.

use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::guess::facet_coefficients::facet_coefficients;
use crate::lad::of_generators::seam::sign_pass::FixedSum;
use crate::numeric::bounded::{Bounded, BoundedVector, approximate};
use crate::numeric::linear::dot;
use crate::numeric::reused::Reused;
use crate::numeric::tolerance::UNIT;

/// The generators whose sign at a vertex is not certain, with their part of the sum g.
pub(super) struct Near {
    pub(super) sum: BoundedVector,
    pub(super) shares: Reused<(usize, f64)>,
    pub(super) shared: f64,
    pub(super) missing: f64,
}

impl Near {
    /// The sum g at a vertex, from the positions of the generators in a level. The products of `duals`, b × p and p ×
    /// a, with a vector x give the coordinates of x in terms of a and b. An error is the position of a generator
    /// along whose line the objective falls.
    pub(super) fn new(
        level: &Reduced,
        [first, second]: [usize; 2],
        near: &[u32],
        direction: &BoundedVector,
        duals: &[BoundedVector; 2],
        fixed: &FixedSum,
    ) -> Result<Self, usize> {
        if near.is_empty() {
            return Ok(Self { sum: fixed.bounded(), shares: Reused::new(), shared: 0.0, missing: 0.0 });
        }
        let product = |v: &[f64; 3], dual: &BoundedVector| dot(v, &dual.map(|c| c.value));
        let own = [product(&level.vectors[first], &duals[0]), product(&level.vectors[second], &duals[1])];
        let plane = |v: &[f64; 3]| [0, 1].map(|k| product(v, &duals[k]) / own[k]);
        let near = near.iter().map(|&place| place as usize);
        let members: Reused<usize> = near.clone().chain([first, second]).collect();
        let vectors: Reused<[f64; 2]> = members.iter().map(|&i| plane(&level.vectors[i])).collect();
        let target = plane(&fixed.sum).map(|c| -c);
        let parts = facet_coefficients(&vectors, target).map_err(|place| members[place])?;
        let (mut total, mut shared, mut missing) = ([0.0; 3], 0.0, 0.0);
        for (i, part) in near.clone().zip(&parts) {
            let v = level.vectors[i];
            for (total, c) in total.iter_mut().zip(v) {
                *total += part * c;
            }
            shared += v.iter().map(|c| c.abs()).sum::<f64>();
            missing += 2.0 * dot(&approximate(v, level.relative_error), direction).magnitude();
        }
        let slack = 1.0 + (near.len() + 8) as f64 * 4.0 * UNIT;
        // a rounding for each product, which may underflow, and one for each addition
        let error = (near.len() + 1) as f64 * (UNIT * shared * slack + f64::MIN_POSITIVE)
            + level.relative_error * shared * slack;
        let sum = [0, 1, 2].map(|k| fixed.bounded()[k] + Bounded { value: total[k], error });
        let shares = near.zip(&parts).map(|(i, &part)| (level.indices[i] as usize, part)).collect();
        Ok(Self { sum, shares, shared: shared * slack, missing: missing * slack })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lad::of_generators::seam::sign_pass::Places;
    use crate::numeric::bounded::{cross, exact};
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::exact_linear;
    use crate::numeric::linear::sum_norm;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The near generators of the vertex of the first two, all others having their signs at it.
    fn near(level: &Reduced, places: &[u32], p: [f64; 3], fixed: &FixedSum) -> Result<Near, usize> {
        let (p, error) = (exact(p), level.relative_error);
        let [a, b] = [0, 1].map(|i| approximate(level.vectors[i], error));
        let direction = cross(&a, &b);
        let places: Places = places.iter().copied().collect();
        Near::new(level, [0, 1], &places, &direction, &[cross(&b, &p), cross(&p, &a)], fixed)
    }

    fn exact_sum(shares: &[(usize, f64)], rows: &[[f64; 3]], start: [f64; 3]) -> exact_linear::ExactVector {
        shares.iter().fold(exact_linear::exact(start), |sum, &(i, share)| {
            let v = exact_linear::exact(rows[i]);
            exact_linear::sum(&sum, &exact_linear::multiple(&Dyadic::from_f64(share), &v))
        })
    }

    /// A facet of the first two with other generators in its plane, or nearly, and one off it.
    fn facet(random: &mut Pcg64Mcg, count: usize, off: f64, scale: f64) -> Vec<[f64; 3]> {
        let mut vector = || [0, 1, 2].map(|_| scale * random.random_range(-1.0..1.0f64));
        let (a, b, c) = (vector(), vector(), vector());
        let mut rows = vec![a, b];
        for _ in 0..count {
            let [s, t, r] = vector().map(|c| c / scale);
            rows.push([0, 1, 2].map(|k| s * a[k] + t * b[k] + off * r * c[k]));
        }
        rows.push(c);
        rows
    }

    #[test]
    fn the_sum_and_what_is_missing_of_it_are_within_their_bounds() {
        let random = &mut Pcg64Mcg::seed_from_u64(71);
        let mut count = 0;
        for round in 0..300 {
            let (members, scale) = (1 + round % 5 * 3, [1.0, 1e-5, 1e5][round % 3]);
            let rows = facet(random, members, [0.0, 1e-9][round / 3 % 2], scale);
            let query = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
            let level = Reduced { relative_error: [0.0, 1e-8][round / 6 % 2], ..Reduced::whole(&query) };
            let last = rows[rows.len() - 1];
            let fixed = FixedSum { sum: last, magnitude: sum_norm(&last), error: 1e-20 * scale, read: 1 };
            let places: Vec<u32> = (2..2 + members as u32).collect();
            // the ray leaves through the facet somewhere near its middle
            let p = [0, 1, 2].map(|k| last[k] + 0.4 * rows[0][k] - 0.3 * rows[1][k] + 0.2 * rows[2][k]);
            let Ok(own) = near(&level, &places, p, &fixed) else { continue };
            count += 1;
            assert!(own.shares.iter().map(|share| share.0).eq(2..2 + members));
            assert!(own.shares.iter().all(|share| share.1.abs() <= 1.0));
            let lengths: f64 = rows[2..2 + members].iter().map(sum_norm).sum();
            assert!(own.shared >= lengths * (1.0 - 1e-15) && own.shared <= lengths * (1.0 + 1e-12), "{}", own.shared);
            let sum = exact_sum(&own.shares, &rows, last);
            for (exact, own) in sum.iter().zip(&own.sum) {
                let off = (exact - &Dyadic::from_f64(own.value)).abs().to_f64();
                // each vector may itself be off by the relative error of its length
                let by_vectors = level.relative_error * lengths;
                let error = own.error;
                assert!(off + by_vectors + fixed.error <= error, "{off} {error}");
                let roundings = (members + 4) as f64 * UNIT * (lengths + sum_norm(&last));
                assert!(error <= (by_vectors + roundings) * 1.01 + 1e-19 * scale, "{error} {members}");
            }
            let normal = exact_linear::cross(&exact_linear::exact(rows[0]), &exact_linear::exact(rows[1]));
            let along = |v: &[f64; 3]| exact_linear::dot(&exact_linear::exact(*v), &normal).abs().to_f64();
            // h(u) − g · u is at most twice the products
            let missing: f64 = rows[2..2 + members].iter().map(|v| 2.0 * along(v)).sum();
            let area = sum_norm(&rows[0]) * sum_norm(&rows[1]);
            assert!(own.missing >= missing * (1.0 - 1e-14), "{} {missing}", own.missing);
            let doubt = (1e-14 + 20.0 * level.relative_error) * lengths * area;
            assert!(own.missing <= missing * (1.0 + 1e-9) + doubt, "{} {missing} {doubt}", own.missing);
            assert!(own.missing >= 2.0 * level.relative_error * lengths * area / 100.0, "{}", own.missing);
        }
        assert!(count > 150, "{count}");
    }

    /// The target is what the fixed sum lacks of a multiple of p, not its opposite.
    #[test]
    fn shares_make_up_for_what_the_sum_lacks() {
        let rows = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 1.0]];
        let query = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
        let level = Reduced::whole(&query);
        let fixed = FixedSum { sum: [0.0, 0.0, 1.0], magnitude: 1.0, error: 0.0, read: 1 };
        for (x, y) in [(3.0, 2.0), (-3.0, 2.0), (4.0, -4.5)] {
            let own = near(&level, &[2, 3], [x, y, 1.0], &fixed).expect("in the facet");
            // what is left is for the two of the vertex
            let [rest_x, rest_y] = [x - own.sum[0].value, y - own.sum[1].value];
            assert!(rest_x.abs() <= 1.0 && rest_y.abs() <= 1.0 && own.missing < 1e-12, "{rest_x} {rest_y}");
        }
        assert!(near(&level, &[2, 3], [9.0, 0.0, 1.0], &fixed).is_err());
        let none = near(&level, &[], [0.5, 0.5, 1.0], &fixed).expect("nothing is near");
        assert_eq!((none.shared, none.missing, none.shares.len(), none.sum[2].value), (0.0, 0.0, 0, 1.0));
    }

    /// Products of the smallest doubles underflow, which the bound covers.
    #[test]
    fn shares_of_the_smallest_generators_are_within_their_bounds() {
        let tiny = 3.0 * 5e-324;
        let mut rows = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        rows.extend([[tiny, 0.0, 0.0]; 9]);
        let query = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
        let level = Reduced::whole(&query);
        let fixed = FixedSum { sum: [0.0, 0.0, 1.0], magnitude: 1.0, error: 0.0, read: 1 };
        let own = near(&level, &(2..11).collect::<Vec<_>>(), [1e-320, 0.0, 1.0], &fixed).expect("in the facet");
        let sum = exact_sum(&own.shares, &rows, [0.0, 0.0, 1.0]);
        for (exact, own) in sum.iter().zip(&own.sum) {
            let off = (exact - &Dyadic::from_f64(own.value)).abs();
            assert!(off <= Dyadic::from_f64(own.error) && own.error >= 9.0 * 5e-324, "{own:?}");
        }
    }
}
