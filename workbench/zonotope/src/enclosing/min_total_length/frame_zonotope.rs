//! A zonotope in the coordinates of the frame: what the searches in floating point find.

use crate::enclosing::fixed_directions::Generation;
use crate::numeric::linear::dot;

/// A zonotope in the coordinates of the frame, around all points but for rounding.
pub(super) struct FrameZonotope<const D: usize> {
    /// Its total length in floating point, with the length of the generators along the axes that it is known to need.
    pub(super) upper: f64,
    pub(super) center: [f64; D],
    pub(super) generators: Vec<[f64; D]>,
    /// Points with coefficients δ_i such that center + Σ δ_i g_i is the point but for rounding, where they are known.
    pub(super) witnesses: Vec<(usize, Vec<f64>)>,
}

impl<const D: usize> FrameZonotope<D> {
    /// The zonotope that a linear program along given directions has found.
    pub(super) fn along(generation: &Generation<'_, D>) -> Self {
        let used = generation.directions().iter().zip(generation.program.coefficients()).filter(|(_, c)| **c > 0.0);
        let generators: Vec<[f64; D]> = used.map(|(v, c)| v.map(|v| v * c)).collect();
        let upper = generators.iter().map(|g| dot(g, g).sqrt()).sum();
        Self { upper, center: generation.program.center(), generators, witnesses: Vec::new() }
    }
}
