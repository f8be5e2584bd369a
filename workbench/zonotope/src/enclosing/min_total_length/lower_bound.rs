//! A lower bound of the lengths of all zonotopes around the points, from multipliers.
//!
//! Multipliers λ_j that add up to zero are feasible once they are divided by ρ, the distance of the farthest vertex of
//! Σ [−1, 1] λ_j from the origin, and then they prove Σ λ_j · p_j / ρ. That is why the search may hand over multipliers
//! of any size, and why its rounding errors cost the bound little and its validity nothing.

use super::answer::LengthMultiplier;
use super::dual_zonotope::{FarVertices, far_vertices};
use super::frame::Frame;
use crate::enclosing::fixed_directions::balanced;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::UNIT;

/// The greatest lower bound so far, and the multipliers in the frame that prove it.
pub(super) struct BestBound<const D: usize> {
    pub(super) lower: f64,
    multipliers: Vec<(usize, [f64; D])>,
}

impl<const D: usize> BestBound<D> {
    /// The bound zero, which needs no multipliers.
    pub(super) fn none() -> Self {
        Self { lower: 0.0, multipliers: Vec::new() }
    }

    /// The multipliers that prove the bound, with the places of their points.
    pub(super) fn multipliers(&self) -> &[(usize, [f64; D])] {
        &self.multipliers
    }

    /// Divides multipliers that add up to zero by the distance of their farthest vertex and keeps them if they prove a
    /// greater bound. Returns that distance and the vertices farther than `least` from the origin.
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

    /// The bound in units of the input and its multipliers: turned out of the frame, balanced again, and the bound that
    /// they prove then computed anew and rounded down.
    pub(super) fn proven(&self, points: &[[f64; D]], frame: &Frame<D>) -> (f64, Vec<LengthMultiplier<D>>) {
        let inside: Vec<[f64; D]> = self.multipliers.iter().map(|(_, f)| *f).collect();
        let rounded: Vec<(usize, [f64; D])> = self.multipliers.iter().map(|(j, f)| (*j, frame.outside(f))).collect();
        let multipliers = balanced(&rounded);
        if multipliers.is_empty() {
            return (0.0, Vec::new());
        }
        // Turning a multiplier out of the frame changes it by a few units in the last place. Balancing rounds every
        // multiplier to a grid of at most 8 UNIT times their total length, and the heaviest one makes up for all
        // others. The farthest vertex moves by no more than the sum of these changes.
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
        (lower.max(0.0), multipliers)
    }
}
