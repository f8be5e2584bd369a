//! The coefficients of many generators of one facet that combine to a vector of its plane: a zonogon's gauge, by one
//! weighted median.
//!
//! Let v_i be the coordinates of the generators in the plane of the facet and t ≠ 0 a vector of that plane. The gauge
//! of t is 1 / s, where s is the least of Σ |v_i · w| over all w with w · t = 1. With w = (t + τ t⊥) / (t · t), the
//! least is at a weighted median of those τ at which one v_i · w vanishes. There Σ σ_i v_i = s t, where σ_i is the
//! sign of v_i · w for every generator but the median one, whose σ makes the sum parallel to t.

use crate::lad::of_generators::guess::crossings::{Crossing, CrossingList};
use crate::numeric::reused::Reused;

/// The coefficients δ_i with Σ δ_i v_i = t up to rounding, |δ_i| ≤ 1; if t is outside the zonogon, the generator that
/// is parallel to the edge beyond which t lies.
pub(crate) fn facet_coefficients(vectors: &[[f64; 2]], [x, y]: [f64; 2]) -> Result<Reused<f64>, usize> {
    let square = x * x + y * y;
    if square == 0.0 {
        return Ok(vectors.iter().map(|_| 0.0).collect());
    }
    let (mut crossings, mut total) = (CrossingList::with_capacity(vectors.len()), 0.0);
    // the product of each generator with t, and with t⊥: the first is the sign of a generator parallel to t, their
    // ratio tells where the others vanish
    let parts: Reused<[f64; 2]> = vectors.iter().map(|[a, b]| [a * x + b * y, b * x - a * y]).collect();
    for (i, &[along, across]) in parts.iter().enumerate() {
        let position = -along / across;
        if position.is_finite() {
            crossings.push(position, across.abs(), i);
            total += across.abs();
        }
    }
    let median = crossings.select(total / 2.0);
    let is_before = |i: usize, position: f64, median: &Crossing| {
        position < median.place || (position == median.place && i < median.line)
    };
    let (mut reach, mut rest) = (0.0, 0.0);
    let mut signs = Reused::with_capacity(vectors.len());
    for (i, &[along, across]) in parts.iter().enumerate() {
        let position = -along / across;
        let sign = match &median {
            Some(median) if median.line == i => 0.0,
            Some(median) if position.is_finite() => {
                f64::copysign(1.0, if is_before(i, position, median) { across } else { -across })
            }
            _ => f64::copysign(1.0, along),
        };
        reach += sign * along;
        rest += sign * across;
        signs.push(sign);
    }
    if let Some(Crossing { line, .. }) = median {
        let [along, across] = parts[line];
        signs[line] = (-rest / across).clamp(-1.0, 1.0);
        reach += signs[line] * along;
    }
    let scale = square / reach;
    match median {
        Some(median) if scale > 1.0 + GAUGE_TOLERANCE => Err(median.line),
        // A sum that is too long by rounding is scaled down, and so is one that rounding turned around, to nothing: the
        // caller bounds what is missing.
        _ => {
            let part = if scale < 0.0 { 0.0 } else { scale.min(1.0) };
            signs.iter_mut().for_each(|sign| *sign *= part);
            Ok(signs)
        }
    }
}

/// A vector whose gauge exceeds 1 by more than this is not in the zonogon.
const GAUGE_TOLERANCE: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;

    fn coefficients(vectors: &[[f64; 2]], target: [f64; 2]) -> Result<Vec<f64>, usize> {
        facet_coefficients(vectors, target).map(|found| found.to_vec())
    }

    #[test]
    fn a_square_worked_out_by_hand() {
        // [−1, 1]² and (1/2, 1/4): the ray leaves through the right edge at (1, 1/2)
        assert_eq!(coefficients(&[[1.0, 0.0], [0.0, 1.0]], [0.5, 0.25]), Ok(vec![0.5, 0.25]));
        // (2, 1) is beyond that edge, which is parallel to the second generator
        assert_eq!(coefficients(&[[1.0, 0.0], [0.0, 1.0]], [2.0, 1.0]), Err(1));
        assert_eq!(coefficients(&[[1.0, 0.0], [0.0, 1.0]], [0.0, 0.0]), Ok(vec![0.0, 0.0]));
    }

    #[test]
    fn coefficients_are_at_most_one_where_rounding_turns_a_sum_around() {
        // parallel but for rounding, and the target orthogonal to them
        for tiny in [5e-324, 1e-300, -1e-300, 1e-17, -1e-17, 3e-17] {
            for target in [[-1.0, 1.0], [1.0, -1.0], [-1.0, 1.0 + f64::EPSILON]] {
                let vectors = [[1.0, 1.0], [3.0 + tiny, 3.0], [0.1 + 0.2, 0.3], [tiny, 0.0], [0.0, tiny]];
                let found = facet_coefficients(&vectors, target);
                assert!(found.is_err() || found.is_ok_and(|shares| shares.iter().all(|share| share.abs() <= 1.0)));
            }
        }
    }

    #[test]
    fn parallel_generators_make_up_for_each_other() {
        let vectors = [[1.0, 0.0], [3.0, 0.0], [-2.0, 0.0], [0.0, 4.0], [0.0, 0.0]];
        let target = [-1.0, 4.0];
        let shares = facet_coefficients(&vectors, target).expect("(−1, 4) is on an edge");
        assert!(shares.iter().all(|share| share.abs() <= 1.0), "{shares:?}");
        let sum = [0, 1].map(|k| shares.iter().zip(&vectors).map(|(share, v)| share * v[k]).sum::<f64>());
        assert_eq!(sum, target);
    }
}
