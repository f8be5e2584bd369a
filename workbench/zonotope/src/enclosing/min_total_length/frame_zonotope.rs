//! A zonotope in the coordinates of the frame.

use crate::enclosing::fixed_directions::Generation;
use crate::zonotope::ray_exit::dot;

/// A zonotope in the frame.
pub(super) struct FrameZonotope<const D: usize> {
    /// Its length, as far as it contains the points.
    pub(super) upper: f64,
    pub(super) center: [f64; D],
    pub(super) generators: Vec<[f64; D]>,
    /// Points with coefficients of the generators that put them in their place, where these are known.
    pub(super) witnesses: Vec<(usize, Vec<f64>)>,
}

impl<const D: usize> FrameZonotope<D> {
    /// The solution of a program over normals.
    pub(super) fn along(generation: &Generation<'_, D>) -> Self {
        let used = generation.directions().iter().zip(generation.program.coefficients()).filter(|(_, c)| **c > 0.0);
        let generators: Vec<[f64; D]> = used.map(|(v, c)| v.map(|v| v * c)).collect();
        let upper = generators.iter().map(|g| dot(g, g).sqrt()).sum();
        Self { upper, center: generation.program.center(), generators, witnesses: Vec::new() }
    }
}
