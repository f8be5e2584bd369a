//! A proven lower bound from the multipliers of a program over normals, however they were found.
//!
//! A normal u with multiplier y_u whose farthest point is j unbalanced at j with y_u u. Rounded to multiples of one power of two the multipliers add up to
//! zero exactly; divided by the most that a direction is loaded with, they are within all limits.

use super::answer::Multiplier;
use super::problem::FixedDirections;
use super::scaled::Scaled;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;
use crate::zonotope::ray_exit::dot;

/// Multipliers in doubles that add up to zero exactly: pairs of a point and a vector.
pub(crate) fn balanced<const D: usize>(unbalanced: &[(usize, [f64; D])]) -> Vec<(usize, [f64; D])> {
    let mut sorted = unbalanced.to_vec();
    sorted.sort_by_key(|(point, _)| *point);
    let mut multipliers: Vec<(usize, [f64; D])> = Vec::with_capacity(sorted.len());
    for (point, pull) in sorted {
        match multipliers.last_mut() {
            Some((last, multiplier)) if *last == point => {
                *multiplier = std::array::from_fn(|c| multiplier[c] + pull[c])
            }
            _ => multipliers.push((point, pull)),
        }
    }
    let total: f64 = multipliers.iter().map(|(_, f)| f.iter().fold(0.0, |max: f64, c| max.max(c.abs()))).sum();
    let Some(exponent) = binary_exponent(total).filter(|_| total.is_finite()) else { return Vec::new() };
    // All partial sums are below 2^(exponent + 2), so multiples of 2^(exponent − 50) add up without rounding.
    let unit = scale_by_power_of_two(1.0, i64::from(exponent) - 50);
    for (_, multiplier) in &mut multipliers {
        *multiplier = multiplier.map(|c| (c / unit).round() * unit);
    }
    let heaviest = (0..multipliers.len()).max_by(|&a, &b| {
        dot(&multipliers[a].1, &multipliers[a].1).total_cmp(&dot(&multipliers[b].1, &multipliers[b].1))
    });
    if let Some(heaviest) = heaviest {
        let others = multipliers.iter().enumerate().filter(|(i, _)| *i != heaviest);
        let sum = others.fold([0.0; D], |sum: [f64; D], (_, (_, f))| std::array::from_fn(|c| sum[c] + f[c]));
        multipliers[heaviest].1 = sum.map(|c| -c);
    }
    multipliers
}

/// The proven bound, in units of the input, and its multipliers; none where a direction that costs nothing is loaded.
pub(crate) fn proven_bound<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    unbalanced: &[(usize, [f64; D])],
) -> (Dyadic, Vec<Multiplier<D>>) {
    let multipliers = balanced(unbalanced);
    let mut share = f64::INFINITY;
    let rounding = 1.0 + (multipliers.len() + 2 * D + 8) as f64 * UNIT;
    for direction in &scaled.directions {
        let load: f64 = multipliers.iter().map(|(_, f)| dot(f, &direction.vector).abs()).sum();
        // A sum of products may vanish only by rounding or underflow; half the least normal number covers the latter.
        let sizes =
            multipliers.iter().map(|(_, f)| f.iter().zip(&direction.vector).map(|(a, b)| (a * b).abs()).sum::<f64>());
        let load = load + 4.0 * UNIT * D as f64 * sizes.sum::<f64>() + f64::MIN_POSITIVE;
        share = share.min(direction.weight / (load * rounding) * (1.0 - 2.0 * UNIT));
    }
    if multipliers.is_empty() || share.is_nan() || share <= 0.0 || share == f64::INFINITY {
        return (Dyadic::zero(), Vec::new());
    }
    let share = Dyadic::from_f64(share).scaled(scaled.weight_exponent);
    let mut bound = Dyadic::zero();
    let mut proof = Vec::with_capacity(multipliers.len());
    let first = problem.points()[0].map(Dyadic::from_f64);
    for (point, multiplier) in multipliers {
        let mut vector: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
        for (component, &c) in multiplier.iter().zip(&scaled.coordinates) {
            let exact = &Dyadic::from_f64(*component) * &share;
            bound = bound + &exact * &(Dyadic::from_f64(problem.points()[point][c]) - first[c].clone());
            vector[c] = exact.to_rational();
        }
        proof.push(Multiplier { point, vector });
    }
    if bound.sign().is_lt() { (Dyadic::zero(), Vec::new()) } else { (bound, proof) }
}
