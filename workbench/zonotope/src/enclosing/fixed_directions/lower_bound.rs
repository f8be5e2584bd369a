//! A proven lower bound from the multipliers of a program over normals, however they were found.
//!
//! A normal u with multiplier y_u whose farthest point is j pulls at j with y_u u. Rounded to multiples of one power of two the forces add up to
//! zero exactly; divided by the most that a direction is loaded with, they are within all limits.

use super::answer::Force;
use super::problem::FixedDirections;
use super::scaled::Scaled;
use crate::numeric::Rational;
use crate::numeric::dyadic::{Dyadic, binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;
use crate::zonotope::ray_exit::dot;

/// Forces in doubles that add up to zero exactly: pairs of a point and a vector.
pub(crate) fn balanced<const D: usize>(pulls: &[(usize, [f64; D])]) -> Vec<(usize, [f64; D])> {
    let mut sorted = pulls.to_vec();
    sorted.sort_by_key(|(point, _)| *point);
    let mut forces: Vec<(usize, [f64; D])> = Vec::with_capacity(sorted.len());
    for (point, pull) in sorted {
        match forces.last_mut() {
            Some((last, force)) if *last == point => *force = std::array::from_fn(|c| force[c] + pull[c]),
            _ => forces.push((point, pull)),
        }
    }
    let total: f64 = forces.iter().map(|(_, f)| f.iter().fold(0.0, |max: f64, c| max.max(c.abs()))).sum();
    let Some(exponent) = binary_exponent(total).filter(|_| total.is_finite()) else { return Vec::new() };
    // All partial sums are below 2^(exponent + 2), so multiples of 2^(exponent − 50) add up without rounding.
    let unit = scale_by_power_of_two(1.0, i64::from(exponent) - 50);
    for (_, force) in &mut forces {
        *force = force.map(|c| (c / unit).round() * unit);
    }
    let heaviest =
        (0..forces.len()).max_by(|&a, &b| dot(&forces[a].1, &forces[a].1).total_cmp(&dot(&forces[b].1, &forces[b].1)));
    if let Some(heaviest) = heaviest {
        let others = forces.iter().enumerate().filter(|(i, _)| *i != heaviest);
        let sum = others.fold([0.0; D], |sum: [f64; D], (_, (_, f))| std::array::from_fn(|c| sum[c] + f[c]));
        forces[heaviest].1 = sum.map(|c| -c);
    }
    forces
}

/// The proven bound, in units of the input, and its forces; none where a direction that costs nothing is loaded.
pub(crate) fn proven_bound<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    pulls: &[(usize, [f64; D])],
) -> (Dyadic, Vec<Force<D>>) {
    let forces = balanced(pulls);
    let mut share = f64::INFINITY;
    let rounding = 1.0 + (forces.len() + 2 * D + 8) as f64 * UNIT;
    for direction in &scaled.directions {
        let load: f64 = forces.iter().map(|(_, f)| dot(f, &direction.vector).abs()).sum();
        // A sum of products may vanish only by rounding or underflow; half the least normal number covers the latter.
        let sizes =
            forces.iter().map(|(_, f)| f.iter().zip(&direction.vector).map(|(a, b)| (a * b).abs()).sum::<f64>());
        let load = load + 4.0 * UNIT * D as f64 * sizes.sum::<f64>() + f64::MIN_POSITIVE;
        share = share.min(direction.weight / (load * rounding) * (1.0 - 2.0 * UNIT));
    }
    if forces.is_empty() || share.is_nan() || share <= 0.0 || share == f64::INFINITY {
        return (Dyadic::zero(), Vec::new());
    }
    let share = Dyadic::from_f64(share).scaled(scaled.weight_exponent);
    let mut bound = Dyadic::zero();
    let mut proof = Vec::with_capacity(forces.len());
    let first = problem.points()[0].map(Dyadic::from_f64);
    for (point, force) in forces {
        let mut vector: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
        for (component, &c) in force.iter().zip(&scaled.coordinates) {
            let exact = &Dyadic::from_f64(*component) * &share;
            bound = bound + &exact * &(Dyadic::from_f64(problem.points()[point][c]) - first[c].clone());
            vector[c] = exact.to_rational();
        }
        proof.push(Force { point, vector });
    }
    if bound.sign().is_lt() { (Dyadic::zero(), Vec::new()) } else { (bound, proof) }
}
