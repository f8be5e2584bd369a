//! A lower bound for all zonotopes around the points: multipliers, made feasible by the farthest vertex of their zonotope.

use super::answer::LengthMultiplier;
use super::dual_zonotope::{FarVertices, far_vertices};
use super::frame::Frame;
use crate::enclosing::fixed_directions::balanced;
use crate::enclosing::outward::rounded_towards;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::UNIT;
use crate::zonotope::ray_exit::dot;

/// The best lower bound so far, and its multipliers in the frame.
pub(super) struct Best<const D: usize> {
    pub(super) lower: f64,
    multipliers: Vec<(usize, [f64; D])>,
}

impl<const D: usize> Best<D> {
    /// Nothing is proven yet.
    pub(super) fn none() -> Self {
        Self { lower: 0.0, multipliers: Vec::new() }
    }

    /// Takes multipliers that add up to zero, made feasible, if they prove more; the vertices farther than `least` from the origin.
    pub(super) fn improve(
        &mut self,
        rank: usize,
        points: &[[f64; D]],
        multipliers: Vec<(usize, [f64; D])>,
        least: f64,
    ) -> FarVertices<D> {
        let vectors: Vec<[f64; D]> = multipliers.iter().map(|(_, f)| *f).collect();
        let far = far_vertices(rank, &vectors, least);
        let lower = multipliers.iter().map(|(j, f)| dot(f, &points[*j])).sum::<f64>() / far.radius;
        if lower > self.lower && lower.is_finite() {
            let multipliers = multipliers.into_iter().map(|(j, f)| (j, f.map(|c| c / far.radius))).collect();
            *self = Self { lower, multipliers };
        }
        far
    }

    /// The bound in units of the input, computed anew and rounded down.
    pub(super) fn proven(&self, points: &[[f64; D]], frame: &Frame<D>) -> (f64, Vec<LengthMultiplier<D>>) {
        let inside: Vec<[f64; D]> = self.multipliers.iter().map(|(_, f)| *f).collect();
        let rounded: Vec<(usize, [f64; D])> = self.multipliers.iter().map(|(j, f)| (*j, frame.outside(f))).collect();
        let multipliers = balanced(&rounded);
        if multipliers.is_empty() {
            return (0.0, Vec::new());
        }
        // Turned out of the frame a multiplier is off by a few units in the last place, and so is what it adds to a vertex; rounding to add up to
        // zero costs each multiplier two more, the heaviest as many as there are.
        let total: f64 = inside.iter().map(|f| dot(f, f).sqrt()).sum();
        let count = multipliers.len() as f64;
        let turned = if frame.rank() == D { 0.0 } else { 16.0 * D as f64 };
        let radius = far_vertices(frame.rank(), &inside, f64::INFINITY).radius;
        let radius = (radius + (turned + 16.0 * count * D as f64) * UNIT * total) * (1.0 + 4.0 * UNIT);
        let mut gain = Dyadic::zero();
        for (j, multiplier) in &multipliers {
            for (a, b) in multiplier.iter().zip(&points[*j]) {
                gain = gain + &Dyadic::from_f64(*a) * &Dyadic::from_f64(*b);
            }
        }
        let mut lower = gain.ratio(&Dyadic::from_f64(radius)).min(f64::MAX);
        while lower > 0.0 && &Dyadic::from_f64(lower) * &Dyadic::from_f64(radius) > gain {
            lower = lower.next_down();
        }
        let multipliers = multipliers.into_iter().map(|(point, vector)| LengthMultiplier { point, vector }).collect();
        (rounded_towards(&Dyadic::from_f64(lower.max(0.0)), f64::NEG_INFINITY), multipliers)
    }
}
