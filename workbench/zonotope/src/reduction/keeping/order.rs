//! The rules that keep some generators as they are and put the others into a parallelepiped.

use super::super::answer::{Problem, Reduced, ReductionError};
use super::super::frame_cover::{Frame, covered};
use super::super::shares::Share;
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};

/// The generators times one power of two, so that none overflows in a product: the largest coordinate is about 1.
pub(in crate::reduction) fn scaled<const D: usize>(generators: &[[f64; D]]) -> Vec<[f64; D]> {
    let exponent = binary_exponent(largest_magnitude(generators.as_flattened())).unwrap_or(0);
    generators.iter().map(|g| g.map(|c| scale_by_power_of_two(c, -i64::from(exponent)))).collect()
}

/// The indices of generators by falling score, of equal scores the lower index first.
pub(super) fn by_falling_score(scores: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..scores.len()).collect();
    order.sort_by(|&a, &b| scores[b].total_cmp(&scores[a]).then(a.cmp(&b)));
    order
}

/// |v|_1 − |v|_∞: how far a generator is from an axis, which is what its box costs.
pub(super) fn distance_from_axes<const D: usize>(v: &[f64; D]) -> f64 {
    v.iter().map(|c| c.abs()).sum::<f64>() - largest_magnitude(v)
}

/// The reduction that keeps the generators `kept` and puts the others into a parallelepiped along a frame.
pub(super) fn with_kept<const D: usize>(
    problem: &Problem<'_, D>,
    kept: &[usize],
    frame: Frame<D>,
) -> Result<Reduced<D>, ReductionError> {
    let own = problem.body().generators();
    let mut shares = vec![None; own.len()];
    for (generator, &index) in kept.iter().enumerate() {
        shares[index] = Some(Share { generator, coefficient: 1.0 });
    }
    covered(problem.body(), kept.iter().map(|&index| own[index]).collect(), shares, frame)
}
