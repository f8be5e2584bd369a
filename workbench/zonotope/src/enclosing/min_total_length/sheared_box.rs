//! The box along the axes with one of its generators slanted along the points, in doubles: nearly a segment around
//! points that are nearly on a line, where doubles hold no segment along that line.

use std::cmp::Ordering;

use dashu_int::ops::Abs;

use super::axis_box::axis_box_around;
use super::on_a_line::of_bits_at_least;
use crate::numeric::Rational;
use crate::numeric::exact_linear::rational;
use crate::numeric::outward::{at_least, axis_generators};
use crate::zonotope::Zonotope;

/// The bits of a half-side before it is rounded to a double: more would not be felt.
const HALF_SIDE_BITS: i64 = 60;

/// The shorter one of the box along the axes and the sheared box, with an upper bound of its length; each has as many
/// generators as there are coordinates at most. `None` where both leave the range of doubles. O(n).
pub(super) fn shortest_box_around<const D: usize>(points: &[[f64; D]]) -> Option<(Zonotope<D>, f64)> {
    let boxes = [axis_box_around(points), sheared_box_around(points)];
    boxes.into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1))
}

/// A zonotope of one generator g from end to end of the points and one along each axis but the longest of g.
///
/// A point p has the coefficient t = (p − c)_m / g_m along g, where m is that axis, so that nothing is left of it along
/// m; along each other axis k the largest |(p − c)_k − t g_k| is the half-side, rounded up.
fn sheared_box_around<const D: usize>(points: &[[f64; D]]) -> Option<(Zonotope<D>, f64)> {
    let order = |a: &&[f64; D], b: &&[f64; D]| a.partial_cmp(b).unwrap_or(Ordering::Equal);
    let ends = [points.iter().min_by(order)?, points.iter().max_by(order)?];
    let center: [f64; D] = std::array::from_fn(|c| ends[0][c].midpoint(ends[1][c]));
    let mut slanted: [f64; D] = std::array::from_fn(|c| ends[1][c] / 2.0 - ends[0][c] / 2.0);
    let longest = (0..D).max_by(|&a, &b| slanted[a].abs().total_cmp(&slanted[b].abs()))?;
    let from_center = |p: &[f64; D], c: usize| rational(p[c]) - rational(center[c]);
    let reach = points.iter().map(|p| from_center(p, longest).abs()).max()?;
    slanted[longest] = at_least(&of_bits_at_least(&reach, HALF_SIDE_BITS)).copysign(slanted[longest]);
    if reach == Rational::ZERO || !slanted.iter().all(|c| c.is_finite()) {
        return None;
    }
    let per_unit = slanted.map(|c| rational(c) / rational(slanted[longest]));
    let halves: [f64; D] = std::array::from_fn(|c| {
        let left = points.iter().map(|p| (from_center(p, c) - from_center(p, longest) * &per_unit[c]).abs()).max();
        let left = left.filter(|left| *left != Rational::ZERO);
        left.map_or(0.0, |left| at_least(&of_bits_at_least(&left, HALF_SIDE_BITS)))
    });
    let body =
        Zonotope::new(center, std::iter::once(slanted).chain(axis_generators(halves)).collect::<Vec<_>>()).ok()?;
    let length = body.total_length();
    length.is_finite().then_some((body, length))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const D: usize>(points: &[[f64; D]]) -> f64 {
        let (body, length) = shortest_box_around(points).expect("within the range");
        assert!(body.generators().len() <= D, "{body:?}");
        assert!(points.iter().all(|&p| body.contains(p) == Ok(true)), "{points:?} {body:?}");
        length
    }

    #[test]
    fn two_points_cost_what_rounding_costs_and_no_more() {
        for [a, b] in [[[3.5f64, -0.6], [9.2, 2.7]], [[0.1, 0.7], [0.3, -0.2]], [[1e-9, 1e9], [7e11, 0.1]]] {
            let half = (a[0] / 2.0 - b[0] / 2.0).hypot(a[1] / 2.0 - b[1] / 2.0);
            // the length is a bound that is rounded up
            assert!(check(&[a, b]) <= half * (1.0 + 1e-14));
        }
        check(&[[0.1, 1.0, 1e-300], [1e17, 0.3, 5e-324]]);
        check(&[[1.0, 2.0], [1.0, 2.0 + 5e-16]]);
    }

    #[test]
    fn points_off_a_line_are_contained() {
        assert_eq!(check(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0]]), 2.0);
        check(&[[0.0, 0.1, 0.7], [1.0, -0.3, 0.2], [0.5, 5.0, -1e-200], [0.25, 0.3, 1e10]]);
    }
}
