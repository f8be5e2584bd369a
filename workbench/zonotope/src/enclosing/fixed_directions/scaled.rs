//! The problem as the methods in floating point see it: in coordinates of the directions' span, with points and
//! directions of ordinary size, and one direction for each line.
//!
//! Every factor is a power of two, so scaling is exact unless a number underflows. What the methods return is a guess,
//! which is proved or enlarged in the units of the input. Of parallel directions only the cheapest is kept: a generator
//! c_i v_i costs w_i c_i, and the cheapest direction makes the same generator for less.

use std::cmp::Ordering;

use super::problem::FixedDirections;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::Span;
use crate::numeric::scaling::{PowerOfTwo, binary_exponent, scale_by_power_of_two, scaled_difference};

/// A direction that is kept: v = `vector` · 2^`exponent` in the coordinates of the span.
pub(crate) struct KeptDirection<const D: usize> {
    /// The index of the direction in the problem.
    pub(crate) index: usize,
    /// The direction scaled so that the magnitude of its largest coordinate lies in [1, 2).
    pub(crate) vector: [f64; D],
    pub(crate) exponent: i64,
    /// The weight of a coefficient of `vector`, scaled by the same power of two for all directions so that the least
    /// positive one is about 1.
    pub(crate) weight: f64,
}

/// Points, directions and weights in scaled coordinates, of which the first `rank` are those of the span and the others
/// are zero.
pub(crate) struct Scaled<const D: usize> {
    pub(crate) rank: usize,
    /// The pivot coordinates of the span: scaled coordinate i is coordinate `coordinates[i]` of the problem.
    pub(crate) coordinates: Vec<usize>,
    /// (point − first point) / 2^`exponent`, rounded.
    pub(crate) points: Vec<[f64; D]>,
    /// Lengths in scaled coordinates times 2^exponent are lengths of the input.
    pub(crate) exponent: i64,
    pub(crate) directions: Vec<KeptDirection<D>>,
    /// The scaled weights times 2^weight_exponent are the problem's weights of the scaled vectors.
    pub(crate) weight_exponent: i64,
}

/// A problem together with the exact span of its directions and its scaled form.
#[derive(Clone, Copy)]
pub(crate) struct Setting<'a, const D: usize> {
    pub(crate) problem: &'a FixedDirections<'a, D>,
    pub(crate) scaled: &'a Scaled<D>,
    pub(crate) span: &'a Span,
}

impl<const D: usize> Scaled<D> {
    /// The difference p − q of two coordinates of the problem in scaled units, rounded once.
    pub(crate) fn difference(&self, p: f64, q: f64) -> f64 {
        scaled_difference(p, q, -self.exponent)
    }

    pub(crate) fn new(problem: &FixedDirections<'_, D>, span: &Span) -> Self {
        let coordinates = span.pivots().collect::<Vec<_>>();
        let inside = |v: &[f64; D]| -> [f64; D] { std::array::from_fn(|i| coordinates.get(i).map_or(0.0, |&c| v[c])) };
        let first = inside(&problem.points()[0]);
        // Where a difference overflows, it is taken of halved coordinates; elsewhere not, since halving rounds the
        // smallest doubles.
        let difference = |p: &[f64; D], half: bool| -> [f64; D] {
            let p = inside(p);
            std::array::from_fn(|i| if half { p[i] / 2.0 - first[i] / 2.0 } else { p[i] - first[i] })
        };
        let largest = |half: bool| {
            let differences = problem.points().iter().flat_map(|p| difference(p, half));
            differences.fold(0.0, |max: f64, c| max.max(c.abs()))
        };
        let whole = largest(false);
        let half = whole == f64::INFINITY;
        let shift = i64::from(half);
        let exponent = binary_exponent(if half { largest(half) } else { whole }).map_or(0, |e| i64::from(e) + shift);
        let factor = PowerOfTwo::new(shift - exponent);
        let points = problem.points().iter().map(|p| difference(p, half).map(|c| factor.apply(c))).collect();
        let directions = cheapest_of_each_line(problem, &inside);
        let costs = || directions.iter().map(|d| (problem.weights()[d.index], d.exponent)).filter(|(w, _)| *w > 0.0);
        let magnitude = |(w, e): (f64, i64)| i64::from(binary_exponent(w).expect("a positive weight")) - e;
        let weight_exponent = costs().map(magnitude).min().unwrap_or(0);
        let weighted = |d: KeptDirection<D>| {
            let weight = scale_by_power_of_two(problem.weights()[d.index], -d.exponent - weight_exponent)
                .min(RELATIVE_WEIGHT_LIMIT);
            KeptDirection { weight, ..d }
        };
        let directions = directions.into_iter().map(weighted).collect();
        Self { rank: coordinates.len(), coordinates, points, exponent, directions, weight_exponent }
    }
}

/// A weight above this multiple of the least one is replaced by that multiple in the search; the proof of the answer
/// uses the true weights.
const RELATIVE_WEIGHT_LIMIT: f64 = 1e100;

/// Of the directions on each line through the origin the cheapest, its weight yet to be filled in.
fn cheapest_of_each_line<const D: usize>(
    problem: &FixedDirections<'_, D>,
    inside: &impl Fn(&[f64; D]) -> [f64; D],
) -> Vec<KeptDirection<D>> {
    let mut kept: Vec<KeptDirection<D>> = Vec::new();
    for (index, v) in problem.directions().iter().enumerate() {
        let v = inside(v);
        let largest = v.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        let Some(exponent) = binary_exponent(largest).map(i64::from) else { continue };
        let vector = v.map(|c| scale_by_power_of_two(c, -exponent));
        let candidate = KeptDirection { index, vector, exponent, weight: 0.0 };
        let same_line = kept.iter_mut().find(|k| {
            nearly_parallel(&k.vector, &vector)
                && parallel(&problem.directions()[k.index], &problem.directions()[index])
        });
        match same_line {
            None => kept.push(candidate),
            Some(other) if is_cheaper(problem, index, other.index) => *other = candidate,
            Some(_) => {}
        }
    }
    kept
}

/// A filter in floating point: false only if two vectors, whose largest coordinates lie in [1, 2), are not parallel.
fn nearly_parallel<const D: usize>(a: &[f64; D], b: &[f64; D]) -> bool {
    let [aa, ab, bb] = [(a, a), (a, b), (b, b)].map(|(x, y)| x.iter().zip(y).map(|(p, q)| p * q).sum::<f64>());
    ab * ab >= (1.0 - 1e-10) * aa * bb
}

/// Whether two vectors are parallel, exactly.
fn parallel<const D: usize>(a: &[f64; D], b: &[f64; D]) -> bool {
    let (a, b) = (a.map(Dyadic::from_f64), b.map(Dyadic::from_f64));
    (0..D).all(|i| (0..i).all(|j| &a[i] * &b[j] == &a[j] * &b[i]))
}

/// Whether a generator along direction `a` costs less than the same generator along `b`, which is parallel to it.
fn is_cheaper<const D: usize>(problem: &FixedDirections<'_, D>, a: usize, b: usize) -> bool {
    let (v, w) = (problem.directions()[a], problem.directions()[b]);
    let Some(axis) = (0..D).find(|&c| v[c] != 0.0) else { return false };
    let cost = |weight: f64, other: f64| &Dyadic::from_f64(weight) * &Dyadic::from_f64(other.abs());
    cost(problem.weights()[a], w[axis]).cmp(&cost(problem.weights()[b], v[axis])) == Ordering::Less
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parallel_directions_leave_the_cheapest() {
        let directions = [[1.0, 2.0], [0.0, 0.0], [-2.0, -4.0], [1.0, 0.0], [0.5, 1.0]];
        let problem =
            FixedDirections::new(&[[0.0, 0.0], [8.0, 1.0]], &directions, &[1.0, 1.0, 1.0, 3.0, 1.0]).expect("valid");
        let scaled = Scaled::new(&problem, &Span::of_doubles(&directions));
        let kept: Vec<usize> = scaled.directions.iter().map(|d| d.index).collect();
        assert_eq!(kept, [2, 3]);
        assert_eq!((scaled.points[1], scaled.exponent), ([1.0, 0.125], 3));
        assert_eq!((scaled.directions[0].vector, scaled.directions[0].exponent), ([-0.5, -1.0], 2));
        assert_eq!(scaled.directions.iter().map(|d| d.weight).collect::<Vec<_>>(), [1.0, 12.0]);
    }
}
