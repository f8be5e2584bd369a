//! A lower bound of the thickness of a body, from a part of its generators.
//!
//! With W = Σ v vᵀ / |v|_∞ over any of the generators and x = W y, the coefficients (v · y) / |v|_∞ combine to x and
//! are at most |y|_1. So the gauge of x = W y is at most |y|_1. Let y_k solve W y_k = e_k but for a rest r_k, |r_k|_∞
//! ≤ ρ < 1/3, and let s be the largest gauge of the e_k. Then s ≤ max |y_k|_1 + 3 ρ s, hence s ≤ max |y_k|_1 / (1 − 3
//! ρ), and the gauge of any x is at most s |x|_1.

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::linear::{cyclic_cross_products, dot, sum_norm};
use crate::numeric::tolerance::{MODERATE_SIZES, UNIT};

/// Generators read side by side.
const LANES: usize = 8;

/// s such that the gauge of any x is at most s |x|_1, from one generator in `share`; infinite if none is found.
pub(crate) fn unit_gauge_bound(query: &dyn KernelQuery, share: usize) -> f64 {
    if let Some(known) = query.known_gauge_bound() {
        return known;
    }
    let [mut xx, mut xy, mut xz, mut yy, mut yz, mut zz] = [0.0; 6];
    let mut count = 0;
    for source in query.parts() {
        // the last ones are always read: they may be the only ones that lead out of a plane
        for part in source.rows.list().chunks(LANES).rev().step_by(share) {
            count += part.len();
            for [x, y, z] in part.iter().map(|v| source.image(v)) {
                let weight = 1.0 / x.abs().max(y.abs()).max(z.abs()).max(f64::MIN_POSITIVE);
                let [wx, wy, wz] = [weight * x, weight * y, weight * z];
                (xx, xy, xz) = (xx + wx * x, xy + wx * y, xz + wx * z);
                (yy, yz, zz) = (yy + wy * y, yz + wy * z, zz + wz * z);
            }
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::query::Query;

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
}
