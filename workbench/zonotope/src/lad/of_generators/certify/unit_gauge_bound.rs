//! A lower bound of the thickness of a body, from a part of its generators.
//!
//! With W = Σ v vᵀ / |v|_∞ over any of the generators and x = W y, the coefficients (v · y) / |v|_∞ combine to x and
//! are at most |y|_1. So the gauge of x = W y is at most |y|_1. Let y_k solve W y_k = e_k but for a rest r_k, |r_k|_∞
//! ≤ ρ < 1/3, and let s be the largest gauge of the e_k. Then s ≤ max |y_k|_1 + 3 ρ s, hence s ≤ max |y_k|_1 / (1 − 3
//! ρ), and the gauge of any x is at most s |x|_1.

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Part;
use crate::numeric::lanes::body_sums::{add_square, are_known, squares, weighted};
use crate::numeric::lanes::number::Units;
use crate::numeric::lanes::octet::LANES;
use crate::numeric::lanes::rows::count_of;
use crate::numeric::linear::{cyclic_cross_products, dot, sum_norm};
use crate::numeric::tolerance::{MODERATE_SIZES, UNIT};

/// s such that the gauge of any x is at most s |x|_1, from one generator in `share`; infinite if none is found.
pub(crate) fn unit_gauge_bound(query: &dyn KernelQuery, share: usize) -> f64 {
    if let Some(known) = query.known_gauge_bound() {
        return known;
    }
    let ([xx, xy, xz, yy, yz, zz], count) = weighted_squares(&query.parts(), share);
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let minors = cyclic_cross_products(&rows[0], &rows[1], &rows[2]);
    let determinant = dot(&rows[0], &minors[0]);
    let inverse = minors.map(|row| row.map(|c| c / determinant));
    let size = inverse.each_ref().map(sum_norm).iter().fold(0.0f64, |m, v| m.max(*v));
    // each entry of the sum is off by a rounding for each term and a few more, in terms of a magnitude that the
    // diagonal bounds; where the vectors themselves are off by a part of their length, each product is off by less
    // than four times that part
    let off = ((count as f64 + 16.0) * 2.0 * UNIT + 16.0 * query.relative_error()) * (xx + yy + zz);
    let mut rest = 0.0f64;
    for (k, column) in inverse.iter().enumerate() {
        for (i, row) in rows.iter().enumerate() {
            let residual = (dot(row, column) - if i == k { 1.0 } else { 0.0 }).abs();
            let magnitude: f64 = row.iter().zip(column).map(|(a, b)| (a * b).abs()).sum();
            rest = rest.max(residual + 8.0 * UNIT * magnitude + off * size);
        }
    }
    let bound = size / (1.0 - 3.0 * rest) * (1.0 + 16.0 * UNIT);
    let is_sound = rest < 0.25 && MODERATE_SIZES.contains(&(xx + yy + zz)) && bound > 0.0;
    if is_sound { bound } else { f64::INFINITY }
}

/// The entries of W on and above the diagonal, and the number of generators that are read: all of them where their sum
/// is known, as that of a body which was prepared is.
fn weighted_squares(parts: &[Part<'_>; 2], share: usize) -> ([f64; 6], usize) {
    let runs = parts.map(|part| part.rows);
    let are_at_rest = parts.iter().all(|part| part.frame.is_none());
    if are_at_rest && (share == 1 || are_known(runs)) {
        return (squares::<true>(runs), count_of(runs));
    }
    let (mut sums, mut count) = ([0.0; 6], 0);
    for source in parts {
        // the last ones are always read: they may be the only ones that lead out of a plane
        for part in source.rows.list().chunks(LANES).rev().step_by(share) {
            count += part.len();
            for v in part.iter().map(|v| source.image(v)) {
                add_square(&mut sums, &weighted::<_, true>(&v, &Units::SINGLE), &v);
            }
        }
    }
    (sums, count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::exact_linear::{self, exact};
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn of(generators: &[[f64; 3]], share: usize) -> f64 {
        unit_gauge_bound(&Query::new([0.0; 3], [0.0; 3], generators).expect("finite"), share)
    }

    #[test]
    fn boxes_worked_out_by_hand() {
        // the gauge of e_k in the box of half-sides 2, 4, 8 is 1/2, 1/4, 1/8
        let sides = [[2.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 8.0]];
        assert!((0.5..0.5 + 1e-12).contains(&of(&sides, 1)));
        // eighty times as thick, of which one run in ten is read: the last
        let many: Vec<[f64; 3]> = sides.iter().copied().cycle().take(240).collect();
        assert!((0.5 / 80.0..0.5 / 80.0 + 1e-12).contains(&of(&many, 1)));
        let part = of(&many, 10);
        assert!((0.5 / 80.0..0.5).contains(&part), "{part}");
    }

    #[test]
    fn nothing_is_said_of_flat_bodies_and_extreme_ones() {
        assert_eq!(of(&[], 1), f64::INFINITY);
        assert_eq!(of(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]], 1), f64::INFINITY);
        assert_eq!(of(&[[1.0, 0.1, 0.0], [0.0, 1.0, 0.1], [1.0, 1.1, 0.1]], 1), f64::INFINITY);
        for size in [1e300, 1e-300] {
            let sides = [[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]];
            assert_eq!(of(&sides, 1), f64::INFINITY);
        }
    }

    /// The largest gauge of the three unit vectors, for generators that are few: by the normals of all pairs.
    fn largest_gauge(query: &dyn KernelQuery) -> f64 {
        let generators: Vec<_> = (0..query.len()).map(|i| query.exact_generator(i)).collect();
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(exact);
        let mut largest = 0.0f64;
        for (i, a) in generators.iter().enumerate() {
            for b in &generators[..i] {
                let normal = exact_linear::cross(a, b);
                let reach = generators.iter().fold(Dyadic::zero(), |sum, v| sum + exact_linear::dot(v, &normal).abs());
                for axis in axes.iter().filter(|_| !reach.is_zero()) {
                    largest = largest.max(exact_linear::dot(axis, &normal).abs().ratio(&reach));
                }
            }
        }
        largest
    }

    #[test]
    fn the_bound_is_above_the_gauges_of_the_unit_vectors_and_not_far_above() {
        let random = &mut Pcg64Mcg::seed_from_u64(51);
        for round in 0..200 {
            let n = 3 + round % 6;
            let scale = [1.0, 1e-9, 1e9, 1e40][round % 4];
            let rows: Vec<[f64; 3]> = (0..n)
                .map(|_| {
                    let size = scale * random.random_range(0.01..1.0f64);
                    [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64))
                })
                .collect();
            let own = largest_gauge(&Query::new([0.0; 3], [0.0; 3], &rows).expect("finite"));
            let bound = of(&rows, 1);
            assert!(own <= bound, "{own} {bound} {rows:?}");
            assert!(bound < 3000.0 * own, "{own} {bound} {rows:?}");
        }
    }

    #[test]
    fn slanted_boxes_are_known_to_a_few_digits_less_than_doubles_have() {
        // in the box of three orthogonal vectors v of lengths l the gauge of e_k is the largest |v_k| / l²
        let sides = [[2.0, 1.0, 2.0], [-2.0, 2.0, 1.0], [1.0, 2.0, -2.0]];
        for (shift, scale) in [(0, 1.0), (1, 1e-5), (2, 1e5)] {
            let lengths = [1.0, 2.0, 4.0];
            let rows: Vec<[f64; 3]> =
                (0..3).map(|i| [0, 1, 2].map(|k| scale * lengths[i] * sides[i][(k + shift) % 3])).collect();
            // W is Σ v vᵀ / |v|_∞ and y_k = W⁻¹ e_k is Σ v v_k |v|_∞ / |v|⁴
            let column = |k: usize| {
                let part = |i: usize, j: usize| {
                    let (v, square) = (rows[i], dot(&rows[i], &rows[i]));
                    v[j] * v[k] * 2.0 * scale * lengths[i] / (square * square)
                };
                (0..3).map(|j| (0..3).map(|i| part(i, j)).sum::<f64>().abs()).sum::<f64>()
            };
            let exact = column(0).max(column(1)).max(column(2));
            let bound = of(&rows, 1);
            assert!(bound >= exact * (1.0 - 1e-14) && bound <= exact * (1.0 + 1e-11), "{bound} {exact}");
        }
    }

    #[test]
    fn nearly_flat_bodies_have_a_bound_that_holds_or_none() {
        let random = &mut Pcg64Mcg::seed_from_u64(52);
        let mut bounded = 0;
        for round in 0..600 {
            let thin = 2f64.powi(-(round % 60));
            let [a, b, c] = [0, 1, 2].map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64)));
            let mut rows = vec![a, b];
            for _ in 0..round % 4 + 1 {
                let [s, t, r] = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
                rows.push([0, 1, 2].map(|k| s * a[k] + t * b[k] + thin * r * c[k]));
            }
            let query = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
            let (own, bound) = (largest_gauge(&query), of(&rows, 1));
            // three times the rest is at most 3/4, so that four times the size is the most that is said
            assert!(own <= bound, "{own} {bound} {rows:?}");
            bounded += u32::from(bound.is_finite());
            assert!(bound.is_finite() || thin < 1e-4 || own > 1e3, "{own} {thin} {rows:?}");
        }
        assert!(bounded > 150, "{bounded}");
    }

    #[test]
    fn flat_bodies_under_matrices_are_not_taken_for_thick_ones() {
        let random = &mut Pcg64Mcg::seed_from_u64(53);
        let mut is_bounded = [0, 0];
        for round in 0..200 {
            let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            let mut rows = vec![vector(), vector()];
            let [a, b] = [rows[0], rows[1]];
            if round % 2 == 0 {
                rows.push(vector());
            } else {
                // flat but for the rounding of images
                rows.extend([[0, 1, 2].map(|k| a[k] + b[k]), [0, 1, 2].map(|k| a[k] - b[k])]);
                rows = rows.into_iter().map(|v| v.map(|c| (c * 1024.0).round())).take(2).collect();
                rows.extend([[0, 1, 2].map(|k| rows[0][k] + rows[1][k]), [0, 1, 2].map(|k| rows[0][k] - rows[1][k])]);
            }
            let body = Zonotope::new([0.0; 3], rows).expect("finite");
            let matrix = [vector(), vector(), vector()];
            let pose = Pose::new(matrix, [0.0; 3]).expect("finite");
            let query = Query::of_placed(body.at(&pose), body.at(&Pose::IDENTITY));
            let single = Zonotope::new([0.0; 3], vec![]).expect("no generators");
            let alone = Query::of_placed(body.at(&pose), single.at(&Pose::IDENTITY));
            for query in [&query as &dyn KernelQuery, &alone] {
                let (own, bound) = (largest_gauge(query), unit_gauge_bound(query, 1));
                assert!(own <= bound, "{own} {bound}");
                is_bounded[round % 2] += u32::from(bound.is_finite());
            }
            if round % 2 == 1 {
                assert_eq!(unit_gauge_bound(&alone, 1), f64::INFINITY, "{matrix:?}");
            }
        }
        assert!(is_bounded[0] > 150, "{is_bounded:?}");
    }

    /// Sums of the diagonal alone tell whether a body is of moderate size.
    #[test]
    fn bodies_of_moderate_size_have_a_bound_whatever_axis_they_are_long_along() {
        for axis in 0..3 {
            let sides = |long: f64, short: f64| {
                [0, 1, 2].map(|i| {
                    [0, 1, 2].map(|k| {
                        if i != k {
                            0.0
                        } else if i == axis {
                            long
                        } else {
                            short
                        }
                    })
                })
            };
            let own = of(&sides(1e-3, 1e-7), 1);
            assert!((1e7..1.001e7).contains(&own), "{own}");
            let own = of(&sides(1e5, 1.0), 1);
            assert!((1.0..1.001).contains(&own), "{own}");
            let own = of(&sides(1e40, 1e40), 1);
            assert!((1e-40..1.001e-40).contains(&own), "{own}");
            assert_eq!(of(&sides(1e70, 1.0), 1), f64::INFINITY);
            assert_eq!(of(&sides(1e62, 1e61), 1), f64::INFINITY);
            assert_eq!(of(&sides(1e-62, 1e-63), 1), f64::INFINITY);
        }
    }
}
