//! A proven lower bound from the multipliers of a program over normals, however they were found.
//!
//! A normal u whose row has the multiplier y_u, and whose farthest point is j, contributes y_u u to the multiplier λ_j
//! of that point. Rounded to multiples of one power of two the multipliers λ_j add up to zero exactly. Divided by the
//! largest quotient of Σ_j |λ_j · v_i| and w_i they satisfy all dual constraints Σ_j |λ_j · v_i| ≤ w_i. So no property
//! of the program's solution has to be trusted.

use super::answer::Multiplier;
use super::problem::FixedDirections;
use super::scaled::Scaled;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;

/// Multipliers in doubles that add up to zero exactly, pairs of a point and a vector, from vectors at points that do so
/// nearly. The vectors at one point are added up, all are rounded, and the longest makes up for the others. Empty if
/// all are zero or one is not finite.
pub(crate) fn balanced<const D: usize>(unbalanced: &[(usize, [f64; D])]) -> Vec<(usize, [f64; D])> {
    let mut sorted = unbalanced.to_vec();
    sorted.sort_by_key(|(point, _)| *point);
    let mut multipliers: Vec<(usize, [f64; D])> = Vec::with_capacity(sorted.len());
    for (point, vector) in sorted {
        match multipliers.last_mut() {
            Some((last, multiplier)) if *last == point => {
                *multiplier = std::array::from_fn(|c| multiplier[c] + vector[c])
            }
            _ => multipliers.push((point, vector)),
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

/// The proven bound in units of the input, and the multipliers that prove it, from vectors at points that add up to
/// nearly zero. The bound is zero, without multipliers, if some λ_j · v_i differs from zero for a direction of weight
/// zero.
pub(crate) fn proven_bound<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    unbalanced: &[(usize, [f64; D])],
) -> (Dyadic, Vec<Multiplier<D>>) {
    let multipliers = balanced(unbalanced);
    let mut factor = f64::INFINITY;
    let rounding = 1.0 + (multipliers.len() + 2 * D + 8) as f64 * UNIT;
    for direction in &scaled.directions {
        let activity: f64 = multipliers.iter().map(|(_, f)| dot(f, &direction.vector).abs()).sum();
        // The sum may be zero by rounding or underflow only. The second term bounds rounding, the third one underflow.
        let sizes =
            multipliers.iter().map(|(_, f)| f.iter().zip(&direction.vector).map(|(a, b)| (a * b).abs()).sum::<f64>());
        let activity = activity + 4.0 * UNIT * D as f64 * sizes.sum::<f64>() + f64::MIN_POSITIVE;
        factor = factor.min(direction.weight / (activity * rounding) * (1.0 - 2.0 * UNIT));
    }
    if multipliers.is_empty() || factor.is_nan() || factor <= 0.0 || factor == f64::INFINITY {
        return (Dyadic::zero(), Vec::new());
    }
    let factor = Dyadic::from_f64(factor).scaled(scaled.weight_exponent);
    let mut bound = Dyadic::zero();
    let mut proof = Vec::with_capacity(multipliers.len());
    let first = problem.points()[0].map(Dyadic::from_f64);
    for (point, multiplier) in multipliers {
        let mut vector: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
        for (component, &c) in multiplier.iter().zip(&scaled.coordinates) {
            let exact = &Dyadic::from_f64(*component) * &factor;
            bound = bound + &exact * &(Dyadic::from_f64(problem.points()[point][c]) - first[c].clone());
            vector[c] = exact.to_rational();
        }
        proof.push(Multiplier { point, vector });
    }
    if bound.sign().is_lt() { (Dyadic::zero(), Vec::new()) } else { (bound, proof) }
}
