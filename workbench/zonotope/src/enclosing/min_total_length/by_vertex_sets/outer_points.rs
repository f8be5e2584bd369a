//! Leaves out points that lie in a simplex of others: every zonotope around the others contains them.
//!
//! Let o be the point farthest from the mean, the apex of all simplices. For another point q, the least Σ α_i with
//! q − o = Σ α_i (e_i − o) and α_i ≥ 0, over points e_i kept so far, is a linear program with as many rows as
//! dimensions. The points of an optimal basis are a simplex with o, and it contains q if Σ α_i ≤ 1. So q is left out
//! if Σ α_i < 1 in floating point and exact signs confirm that it is inside the simplex. Points far from the mean are
//! taken first, as they are likely corners. The exact convex hull would leave out more points, but in higher dimensions
//! it costs more than the search.

use std::cmp::Ordering;

use crate::enclosing::min_total_length::frame::Frame;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::determinant;
use crate::numeric::linear::{dot, inverse};

/// Fewer points than this are all kept: their linear programs would cost more than the points cost the search.
const LEAST_POINT_COUNT: usize = 48;

/// The search for a simplex around a point ends after this many pivots, and the point is kept.
const PIVOT_LIMIT: usize = 60;

/// The cost of an axis that stands in for a point in the first basis, where a point costs 1: no axis stays in an
/// optimal basis if points can replace it.
const AXIS_COST: f64 = 1e6;

/// Only this many points, the first ones kept, are corners of simplices. If more points are kept, and they are more
/// than seven eighths of the points seen, all further points are kept.
const CORNER_LIMIT: usize = 500;

/// Coefficients below this count as zero; a point with such a coefficient is near the boundary of the simplex and is
/// kept.
const LEAST_COEFFICIENT: f64 = 1e-9;

/// The places of the points that are not proven to lie in a simplex of others, without duplicates. Where points are few
/// or do not span the space, only duplicates are left out.
pub(in crate::enclosing::min_total_length) fn outer_points<const D: usize>(points: &[[f64; D]]) -> Vec<usize> {
    let all = || distinct(points, (0..points.len()).collect());
    if points.len() < LEAST_POINT_COUNT || D < 3 {
        return all();
    }
    let frame = Frame::new(points);
    if frame.rank() < D {
        return all();
    }
    let inside = &frame.points;
    let count = points.len() as f64;
    let sum = inside.iter().fold([0.0; D], |sum, p| std::array::from_fn(|c| sum[c] + p[c]));
    let distance = |j: usize| {
        let apart: [f64; D] = std::array::from_fn(|c| inside[j][c] - sum[c] / count);
        dot(&apart, &apart)
    };
    let mut order: Vec<(f64, usize)> = (0..points.len()).map(|j| (distance(j), j)).collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let apex = order[0].1;
    let mut kept = vec![apex];
    let mut relative: Vec<[f64; D]> = Vec::new();
    for (done, &(_, j)) in order.iter().enumerate().skip(1) {
        if kept.len() > CORNER_LIMIT && 8 * kept.len() > 7 * done {
            kept.push(j);
            continue;
        }
        let q: [f64; D] = std::array::from_fn(|c| inside[j][c] - inside[apex][c]);
        let is_inner = simplex_around(&relative, &q).is_some_and(|basis| {
            let corners = basis.map(|i| kept[i + 1]);
            is_in_simplex(&points[j], &points[apex], &corners.map(|i| points[i]))
        });
        if !is_inner {
            kept.push(j);
            if relative.len() < CORNER_LIMIT {
                relative.push(q);
            }
        }
    }
    distinct(points, kept)
}

/// Of equal points the place of the first, in increasing order.
fn distinct<const D: usize>(points: &[[f64; D]], mut places: Vec<usize>) -> Vec<usize> {
    let order = |a: &usize, b: &usize| points[*a].partial_cmp(&points[*b]).unwrap_or(Ordering::Equal).then(a.cmp(b));
    places.sort_unstable_by(order);
    places.dedup_by_key(|place| points[*place]);
    places.sort_unstable();
    places
}

/// The corners of a simplex with the origin that contains q but for rounding.
fn simplex_around<const D: usize>(points: &[[f64; D]], q: &[f64; D]) -> Option<[usize; D]> {
    // The first basis is the axes with the signs of q, marked by `usize::MAX`: artificial corners that have to leave.
    let mut basis = [usize::MAX; D];
    let mut columns: [[f64; D]; D] =
        std::array::from_fn(|a| std::array::from_fn(|c| if a == c { 1f64.copysign(q[c]) } else { 0.0 }));
    for _ in 0..PIVOT_LIMIT {
        let matrix = std::array::from_fn(|row| std::array::from_fn(|i| columns[i][row]));
        let rows = inverse(D, &matrix)?;
        let alphas: [f64; D] = std::array::from_fn(|i| dot(&rows[i], q));
        let is_whole = basis.iter().all(|&i| i != usize::MAX);
        if is_whole && alphas.iter().sum::<f64>() < 1.0 - LEAST_COEFFICIENT {
            return alphas.iter().all(|&alpha| alpha > LEAST_COEFFICIENT).then_some(basis);
        }
        let mut price = [0.0; D];
        for (i, row) in rows.iter().enumerate() {
            let cost = if basis[i] == usize::MAX { AXIS_COST } else { 1.0 };
            price = std::array::from_fn(|c| price[c] + cost * row[c]);
        }
        let mut best = (1.0 + LEAST_COEFFICIENT, usize::MAX);
        for (i, point) in points.iter().enumerate() {
            let worth = dot(&price, point);
            if worth > best.0 {
                best = (worth, i);
            }
        }
        let entering = points.get(best.1)?;
        let leaving = (0..D)
            .filter_map(|i| {
                let rate = dot(&rows[i], entering);
                (rate > LEAST_COEFFICIENT * LEAST_COEFFICIENT).then(|| (alphas[i].max(0.0) / rate, i))
            })
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        basis[leaving.1] = best.1;
        columns[leaving.1] = *entering;
    }
    None
}

/// Whether a point lies in the interior of a simplex, exactly.
fn is_in_simplex<const D: usize>(q: &[f64; D], apex: &[f64; D], corners: &[[f64; D]; D]) -> bool {
    let difference = |p: &[f64; D]| -> Vec<Dyadic> {
        p.iter().zip(apex).map(|(a, b)| Dyadic::from_f64(*a) - Dyadic::from_f64(*b)).collect()
    };
    let rows: Vec<Vec<Dyadic>> = corners.iter().map(difference).collect();
    let q = difference(q);
    let whole = determinant(&rows);
    let mut rest = whole.clone();
    // Cramer's rule yields the coefficients of the corners; the apex has what they leave of 1.
    let is_within = (0..D).all(|i| {
        let replaced: Vec<Vec<Dyadic>> =
            rows.iter().enumerate().map(|(r, row)| if r == i { q.clone() } else { row.clone() }).collect();
        let part = determinant(&replaced);
        rest = &rest - &part;
        part.sign() == whole.sign()
    });
    is_within && !whole.is_zero() && rest.sign() == whole.sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_grid_in_a_cube_the_inner_points_are_left_out() {
        let side = [-2.0, -1.0, 0.0, 1.0, 2.0];
        let mut points: Vec<[f64; 3]> = Vec::new();
        for x in side {
            for y in side {
                // Inner points are moved off the planes through corners.
                let off = |c: f64, by: f64| if c.abs() < 2.0 { c + by } else { c };
                points.extend(side.map(|z| [off(x, 0.1 * y + 0.02), off(y, 0.13 * z + 0.03), off(z, 0.07 * x + 0.05)]));
            }
        }
        let kept = outer_points(&points);
        let corner = |p: &[f64; 3]| p.iter().all(|c| c.abs() == 2.0);
        assert!((0..points.len()).filter(|&j| corner(&points[j])).all(|j| kept.contains(&j)));
        let inner = |p: &[f64; 3]| p.iter().all(|c| c.abs() < 1.5);
        // Ties end the search for some inner points, which are kept.
        assert!(kept.iter().filter(|&&j| inner(&points[j])).count() <= 2, "{kept:?}");
        let corners = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
        assert!(is_in_simplex(&[1.0, 1.0, 1.0], &[0.0; 3], &corners));
        assert!(!is_in_simplex(&[2.0, 1.0, 1.0], &[0.0; 3], &corners));
    }

    #[test]
    fn of_equal_points_the_first_is_kept() {
        assert_eq!(outer_points(&[[1.0, 0.0], [0.0, 2.0], [1.0, -0.0], [0.0, 2.0], [3.0, 3.0]]), [0, 1, 4]);
    }
}
