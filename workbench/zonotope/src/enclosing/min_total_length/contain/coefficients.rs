//! Coefficients δ_i in [−1, 1] with Σ δ_i g_i equal to a vector but for rounding, from coefficients that are nearly
//! right.
//!
//! The room of a coefficient is its distance from ±1. What Σ δ_i g_i misses of the vector is made up for by changes Δ_i
//! with the least Σ (Δ_i / room_i)²: so coefficients with much room change most, and few are pushed beyond ±1 and cut
//! off there. A least-squares change without weights would push all alike.

use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::numeric::linear::{dot, inverse};

/// The coefficients for a vector are corrected at most this many times.
const ROUND_LIMIT: usize = 8;

/// A remainder shorter than this share of the vector counts as zero.
const NEGLIGIBLE_REMAINDER: f64 = 4e-15;

/// Where corrections fail because too many coefficients are at ±1, all coefficients are first reduced by this share.
const FIRST_REDUCTION: f64 = 1e-6;

/// The square of the room of a coefficient at ±1: above zero, so that the equations stay regular.
const ROOM_AT_LIMIT: f64 = 1e-20;

/// The rounding error of a vector, relative to the longest extent of the body. Across a thin body it is large in box
/// coordinates; its square joins the diagonal of the equations, so that coefficients are not changed for the sake of
/// rounding errors.
const RELATIVE_ROUNDING: f64 = 1e-15;

/// The generators of a zonotope in the frame and in box coordinates, as refining coefficients needs them.
pub(super) struct CoefficientRefinement<'a, const D: usize> {
    coordinates: &'a BoxCoordinates<'a, D>,
    rank: usize,
    generators: &'a [[f64; D]],
    pub(super) in_box: Vec<[f64; D]>,
    /// The square of the rounding error of a vector along each axis, in box coordinates.
    squared_rounding: [f64; D],
}

impl<'a, const D: usize> CoefficientRefinement<'a, D> {
    pub(super) fn new(coordinates: &'a BoxCoordinates<'a, D>, rank: usize, generators: &'a [[f64; D]]) -> Self {
        let in_box = generators.iter().map(|g| coordinates.vector(g)).collect();
        let squared_rounding = coordinates.thinness().map(|thin| (RELATIVE_ROUNDING / thin).powi(2));
        Self { coordinates, rank, generators, in_box, squared_rounding }
    }

    /// Coefficients whose sum Σ δ_i g_i misses no more of the ray than that of the given ones.
    pub(super) fn refined(&self, ray: &[f64; D], deltas: Vec<f64>) -> Vec<f64> {
        let tolerance = NEGLIGIBLE_REMAINDER * dot(ray, ray).sqrt();
        let (missed, deltas) = self.corrected(ray, deltas, tolerance);
        if missed <= tolerance {
            return deltas;
        }
        let shorter = deltas.iter().map(|delta| delta * (1.0 - FIRST_REDUCTION)).collect();
        let other = self.corrected(ray, shorter, tolerance);
        if other.0 < missed { other.1 } else { deltas }
    }

    /// The length of the remainder that corrections leave at best, and the coefficients that leave it.
    fn corrected(&self, ray: &[f64; D], mut deltas: Vec<f64>, tolerance: f64) -> (f64, Vec<f64>) {
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
            if missed <= tolerance || !self.correct(&self.coordinates.vector(&left), &mut deltas) {
                break;
            }
        }
        best
    }

    /// Changes the coefficients by one correction for a remainder `left`, in box coordinates. False if the equations
    /// are singular.
    fn correct(&self, left: &[f64; D], deltas: &mut [f64]) -> bool {
        let mut matrix = [[0.0; D]; D];
        let squared_rooms: Vec<f64> = deltas.iter().map(|delta| squared_room(*delta)).collect();
        for (g, weight) in self.in_box.iter().zip(&squared_rooms) {
            for (row, &a) in matrix.iter_mut().zip(g) {
                for (entry, &b) in row.iter_mut().zip(g) {
                    *entry += weight * a * b;
                }
            }
        }
        for (axis, row) in matrix.iter_mut().enumerate() {
            row[axis] += self.squared_rounding[axis];
        }
        let Some(inverse) = inverse(self.rank, &matrix) else { return false };
        let solution = inverse.map(|row| dot(&row, left));
        for ((g, delta), room) in self.in_box.iter().zip(deltas).zip(squared_rooms) {
            *delta = (*delta + room * dot(g, &solution)).clamp(-1.0, 1.0);
        }
        true
    }
}

/// The square of the room of a coefficient: of its distance from ±1, and a little more than zero at ±1.
fn squared_room(delta: f64) -> f64 {
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
        let refinement = CoefficientRefinement::new(&coordinates, frame.rank(), &boxed.generators);
        for point in &frame.points {
            let ray = std::array::from_fn(|c| point[c] - boxed.center[c]);
            let deltas = refinement.refined(&ray, vec![0.0; 3]);
            let (missed, _) = refinement.corrected(&ray, deltas.clone(), f64::INFINITY);
            assert!(missed < 1e-15 && deltas.iter().all(|delta| delta.abs() <= 1.0), "{missed:e} {deltas:?}");
        }
    }
}
