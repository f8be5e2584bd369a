//! The point of a zonotope that is nearest to another point, sought in floating point: one coefficient after the other.
//!
//! Whatever the search finds is a point of the zonotope, so a distance that is computed for it with a bound of all
//! rounding proves how near the zonotope is at most. It need not be the least distance.

use crate::faces::normals::{Image, UNDERFLOW, image_dot};

/// The search ends after so many rounds over all coefficients.
const MOST_ROUNDS: usize = 30;

/// A relative bound of what the rounding of a sum of squares and its root may lose.
const LENGTH_ERROR: f64 = 16.0 * f64::EPSILON;

/// A zonotope as images.
pub(super) struct RoundedBody<'a> {
    generators: &'a [Image],
    squares: Vec<f64>,
}

impl<'a> RoundedBody<'a> {
    pub(super) fn new(generators: &'a [Image]) -> Self {
        Self { generators, squares: generators.iter().map(|g| image_dot(g, g)).collect() }
    }

    /// Whether a point of the zonotope is found that is for sure no farther from the point than the limit.
    pub(super) fn is_near(&self, point: &Image, limit: f64) -> bool {
        // The first guess is the vertex that lies farthest towards the point.
        let towards = |g: &Image| if image_dot(g, point) < 0.0 { -1.0 } else { 1.0 };
        let mut coefficients: Vec<f64> = self.generators.iter().map(towards).collect();
        let mut rest = *point;
        self.generators.iter().zip(&coefficients).for_each(|(g, &factor)| subtract(&mut rest, factor, g));
        for _ in 0..MOST_ROUNDS {
            let has_changed = self.improve(&mut coefficients, &mut rest);
            if length(&rest) <= limit && self.farthest(point, &coefficients) <= limit {
                return true;
            }
            if !has_changed {
                return false;
            }
        }
        false
    }

    /// Improves each coefficient once; whether one of them changed.
    fn improve(&self, coefficients: &mut [f64], rest: &mut Image) -> bool {
        let mut has_changed = false;
        for ((g, &square), coefficient) in self.generators.iter().zip(&self.squares).zip(coefficients) {
            if square == 0.0 {
                continue;
            }
            let better = (*coefficient + image_dot(g, rest) / square).clamp(-1.0, 1.0);
            if better != *coefficient && !better.is_nan() {
                subtract(rest, better - *coefficient, g);
                *coefficient = better;
                has_changed = true;
            }
        }
        has_changed
    }

    /// The distance of a point from that with the given coefficients, at most.
    ///
    /// An image is within a relative 2^-52 of the exact vector or off by less than [`UNDERFLOW`], a product and a sum
    /// of n terms are within n + 1 roundings of half as much: all of it is below n + 8 times 2^-52 of the magnitudes.
    fn farthest(&self, point: &Image, coefficients: &[f64]) -> f64 {
        let (mut rest, mut size) = (*point, point.map(f64::abs));
        for (g, &factor) in self.generators.iter().zip(coefficients) {
            subtract(&mut rest, factor, g);
            for (size, c) in size.iter_mut().zip(g) {
                *size += (factor * c).abs();
            }
        }
        let count = (self.generators.len() + 8) as f64;
        let off: Image =
            std::array::from_fn(|axis| rest[axis].abs() + size[axis] * count * f64::EPSILON + count * UNDERFLOW);
        length(&off) * (1.0 + LENGTH_ERROR)
    }
}

/// The length of a vector, its squares in terms of the largest one: those of small components would vanish.
fn length(vector: &Image) -> f64 {
    let largest = vector.iter().fold(0.0, |largest, c| c.abs().max(largest));
    if largest == 0.0 {
        return 0.0;
    }
    let unit = vector.map(|c| c / largest);
    largest * image_dot(&unit, &unit).sqrt()
}

fn subtract(from: &mut Image, factor: f64, vector: &Image) {
    for (slot, c) in from.iter_mut().zip(vector) {
        *slot -= factor * c;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_points_of_a_square() {
        let square = [[0.5, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0]];
        let body = RoundedBody::new(&square);
        let is_near = |x: f64, y: f64, limit: f64| body.is_near(&[x, y, 0.0, 0.0], limit);
        assert!(is_near(0.25, 0.5, 1e-9) && !is_near(0.25, 0.5, 0.0), "rounding is not excluded");
        assert!(is_near(0.875, 1.0, 0.6251) && !is_near(0.875, 1.0, 0.6249));
        assert!(!RoundedBody::new(&[]).is_near(&[0.5, 0.0, 0.0, 0.0], 0.4));
    }

    #[test]
    fn the_search_begins_at_the_vertex_towards_the_point() {
        // the coefficients of a thin body hardly move in thirty rounds: the far tip is found at once or not at all
        let thin = 0.5 / 1024.0;
        let rhombus = [[0.5, thin, 0.0, 0.0], [-0.5, thin, 0.0, 0.0]];
        let is_near = |y: f64| RoundedBody::new(&rhombus).is_near(&[0.0, y, 0.0, 0.0], 0.25 + 1e-9);
        assert!(is_near(0.25 + 2.0 * thin) && is_near(-0.25 - 2.0 * thin), "the tips are the nearest points");
        // a generator across the point is taken as it is
        let across = [[0.5, thin, 0.0, 0.0], [-0.5, 0.0, 0.0, 0.0]];
        assert!(RoundedBody::new(&across).is_near(&[0.0, 0.25 + thin, 0.0, 0.0], 0.25 + 1e-9));
    }

    #[test]
    fn the_search_goes_on_as_long_as_coefficients_change() {
        // the point is half of one generator and a quarter of the other, with an angle of 45° between them
        let skew = [[0.5, 0.0, 0.0, 0.0], [0.5, 0.5, 0.0, 0.0]];
        assert!(RoundedBody::new(&skew).is_near(&[0.375, 0.125, 0.0, 0.0], 1e-6));
    }

    #[test]
    fn a_distance_is_as_near_as_the_limit_that_it_equals() {
        let (body, point) = (RoundedBody::new(&[]), [0.375, 0.5, 0.0, 0.0]);
        let farthest = body.farthest(&point, &[]);
        assert!(body.is_near(&point, farthest) && !body.is_near(&point, farthest.next_down()));
    }

    #[test]
    fn distances_are_exceeded_by_what_rounding_may_lose() {
        // the distance from (1/2, 0) to (7/8, 1/2) is 5/8; magnitudes of (11/8, 1/2), times 10 for two generators, and
        // 16 for the root: (3/5 · 11/8 + 4/5 · 1/2) · 10 + 5/8 · 16 = 22.25
        let square = [[0.5, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0]];
        let farthest = RoundedBody::new(&square).farthest(&[0.875, 0.5, 0.0, 0.0], &[1.0, 0.0]);
        let excess = (farthest - 0.625) / f64::EPSILON;
        assert!((21.5..23.0).contains(&excess), "{excess}");
    }

    #[test]
    fn distances_whose_squares_vanish_are_no_less() {
        let body = RoundedBody::new(&[[0.5, 0.0, 0.0, 0.0]]);
        for size in [1e-170, 1e-200, 1e-280] {
            let is_near = |limit: f64| body.is_near(&[0.5, 0.0, size, 0.0], limit);
            assert!(!is_near(0.0) && !is_near(1e-300) && !is_near(0.5 * size), "{size}");
        }
        assert!(body.is_near(&[0.5, 1e-170, 0.0, 0.0], 1e-14));
        // components that are left out of images may be that large
        let left_out = 9.0 * UNDERFLOW;
        assert!(!body.is_near(&[0.0, left_out, 0.0, 0.0], 0.5 * left_out));
    }
}
