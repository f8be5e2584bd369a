//! Coefficients in [−1, 1] of generators that put a point in its place, from nearly right ones.
//!
//! What they miss is made up for by the generators with room, in proportion to the squares of their rooms: as little as
//! possible, measured by how much of each room it takes.

use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::zonotope::ray_exit::{dot, inverse};

/// Coefficients are corrected at most this many times.
const ROUND_LIMIT: usize = 8;

/// A remainder of a ray that is shorter than this share of the ray counts as zero.
const NEGLIGIBLE_REMAINDER: f64 = 4e-15;

/// Where corrections fail since coefficients leave no room, all coefficients are first reduced by this share.
const FIRST_REDUCTION: f64 = 1e-6;

/// The square of the room of a coefficient at its limit: above zero, so that no weight vanishes.
const ROOM_AT_LIMIT: f64 = 1e-20;

/// What rounding may leave of a vector beside the longest extent of the body: where that is across a thin body,
/// corrections are held back.
const RELATIVE_ROUNDING: f64 = 1e-15;

/// The generators of a zonotope, in a frame and in box coordinates.
pub(super) struct Settling<'a, const D: usize> {
    coordinates: &'a BoxCoordinates<'a, D>,
    rank: usize,
    generators: &'a [[f64; D]],
    pub(super) in_box: Vec<[f64; D]>,
    /// The squares of what rounding may leave along each axis, in box coordinates.
    rounding: [f64; D],
}

impl<'a, const D: usize> Settling<'a, D> {
    pub(super) fn new(coordinates: &'a BoxCoordinates<'a, D>, rank: usize, generators: &'a [[f64; D]]) -> Self {
        let in_box = generators.iter().map(|g| coordinates.vector(g)).collect();
        let rounding = coordinates.thinness().map(|thin| (RELATIVE_ROUNDING / thin).powi(2));
        Self { coordinates, rank, generators, in_box, rounding }
    }

    /// Coefficients that miss less of the ray, or the same.
    pub(super) fn settled(&self, ray: &[f64; D], deltas: Vec<f64>) -> Vec<f64> {
        let enough = NEGLIGIBLE_REMAINDER * dot(ray, ray).sqrt();
        let (missed, deltas) = self.corrected(ray, deltas, enough);
        if missed <= enough {
            return deltas;
        }
        let shorter = deltas.iter().map(|delta| delta * (1.0 - FIRST_REDUCTION)).collect();
        let other = self.corrected(ray, shorter, enough);
        if other.0 < missed { other.1 } else { deltas }
    }

    /// The best coefficients on the way, and what they miss.
    fn corrected(&self, ray: &[f64; D], mut deltas: Vec<f64>, enough: f64) -> (f64, Vec<f64>) {
        let mut best = (f64::INFINITY, Vec::new());
        for _ in 0..ROUND_LIMIT {
            let left = self
                .generators
                .iter()
                .zip(&deltas)
                .fold(*ray, |left, (g, delta)| std::array::from_fn(|c| left[c] - delta * g[c]));
            let missed = dot(&left, &left).sqrt();
            if missed.is_nan() || missed >= best.0 {
                break;
            }
            best = (missed, deltas.clone());
            if missed <= enough || !self.correct(&self.coordinates.vector(&left), &mut deltas) {
                break;
            }
        }
        best
    }

    /// One correction by what is left; whether there is one.
    fn correct(&self, left: &[f64; D], deltas: &mut [f64]) -> bool {
        let mut matrix = [[0.0; D]; D];
        let rooms: Vec<f64> = deltas.iter().map(|delta| room(*delta)).collect();
        for (g, weight) in self.in_box.iter().zip(&rooms) {
            for (row, &a) in matrix.iter_mut().zip(g) {
                for (entry, &b) in row.iter_mut().zip(g) {
                    *entry += weight * a * b;
                }
            }
        }
        for (axis, row) in matrix.iter_mut().enumerate() {
            row[axis] += self.rounding[axis];
        }
        let Some(inverse) = inverse(self.rank, &matrix) else { return false };
        let pull = inverse.map(|row| dot(&row, left));
        for ((g, delta), room) in self.in_box.iter().zip(deltas).zip(rooms) {
            *delta = (*delta + room * dot(g, &pull)).clamp(-1.0, 1.0);
        }
        true
    }
}

/// The square of how far a coefficient is from its limits, and a little for one at its limit.
fn room(delta: f64) -> f64 {
    (1.0 - delta.abs()).powi(2) + ROOM_AT_LIMIT
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosing::min_total_length::frame::Frame;

    #[test]
    fn a_point_of_a_thin_box_is_put_in_its_place() {
        let width = 1e-9;
        let points = [[1.0, 0.0, 0.0], [-1.0, width, 0.0], [0.0, 0.0, width]];
        let frame = Frame::new(&points);
        let coordinates = BoxCoordinates::of(&frame);
        let boxed = coordinates.boxed();
        let settling = Settling::new(&coordinates, frame.rank(), &boxed.generators);
        for point in &frame.points {
            let ray = std::array::from_fn(|c| point[c] - boxed.center[c]);
            let deltas = settling.settled(&ray, vec![0.0; 3]);
            let (missed, _) = settling.corrected(&ray, deltas.clone(), f64::INFINITY);
            assert!(missed < 1e-15 && deltas.iter().all(|delta| delta.abs() <= 1.0), "{missed:e} {deltas:?}");
        }
    }
}
